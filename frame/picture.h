/// Colour pictures in linear light. Primary visibility is never judged from them.
#pragma once

#include <cstdint>

#include "frame/plane.h"

namespace zproof {

/// Linear light, Rec. 709 primaries (those of sRGB); 0 black, 1 the brightest that an sRGB picture can show.
struct LinearRgb {
    float r = 0, g = 0, b = 0;
    bool operator==(const LinearRgb&) const = default;
};

using Picture = Plane<LinearRgb>;

/// sRGB.
struct Rgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb8&) const = default;
};

}  // namespace zproof
