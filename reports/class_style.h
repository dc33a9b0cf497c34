/// How a pixel class looks: fixed for every report. Blues are admissible ties, greens somebody else's flaw,
/// warm colours and white are defects; glyph and name say the same without colour.
#pragma once

#include <string_view>

#include "compare/pixel_class.h"
#include "frame/png.h"

namespace zproof {

struct ClassStyle {
    Rgb8 colour;  ///< Okabe and Ito's palette (2008), two tints added; reads on the map's dark ground
    std::string_view glyph;    ///< one character wide
    std::string_view meaning;  ///< one sentence for strangers
};

/// The style of a class; c must be one of the enumerators.
const ClassStyle& style_of(PixelClass c);

}  // namespace zproof
