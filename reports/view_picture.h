/// What the candidate saw of a view, with rings around what differs: the picture by which a page shows a
/// view.
#pragma once

#include <functional>

#include "compare/pixel_class.h"
#include "frame/frame.h"
#include "frame/picture.h"

namespace zproof {

/// How large a picture is, and how smooth.
struct PictureSize {
    int longest_side;      ///< pixels
    int samples_per_side;  ///< pixels of the view, along x and along y, whose mean a pixel of the picture is
};
inline constexpr PictureSize card_picture{320, 2}, large_picture{960, 1};

/// The size of the picture of a view. Of a view that fits more than once each pixel becomes a square of whole
/// pixels.
Resolution resolution_of(PictureSize size, Resolution view);

/// The colour, in linear light, that the candidate gives to a pixel of the view.
using ColourAt = std::function<LinearRgb(int x, int y)>;

/// Where a pixel of the picture holds several samples, those of one triangle are shaded once.
/// A pixel of the view that is not `agree` has a ring of its class's colour; rings of neighbours are one
/// outline, and pixels within it that fail the gate have their class's colour. Where rings meet, the severest
/// class is seen. On the threads of the surrounding tbb::task_arena.
Plane<Rgb8> view_picture(const Plane<PixelClass>& classes, const Plane<PrimitiveId>& ids,
                         const ColourAt& colour_at, PictureSize size);

}  // namespace zproof
