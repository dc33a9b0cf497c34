/// What the candidate saw of a view, with rings around what differs: the picture by which a page shows a
/// view.
#pragma once

#include <functional>

#include "compare/pixel_class.h"
#include "frame/picture.h"

namespace zproof {

inline constexpr int view_picture_side =
    320;  ///< its longest side, pixels, unless the view's fits more than once

/// The size of the picture: its longest side is view_picture_side; of a smaller view each pixel becomes a
/// square of whole pixels.
Resolution view_picture_size(Resolution view);

/// The colour, in linear light, that the candidate gives to a pixel of the view.
using ColourAt = std::function<LinearRgb(int x, int y)>;

/// Every pixel of the picture is the mean of four pixels of the view. A pixel of the view that is not `agree`
/// has a ring of its class's colour; rings of neighbours are one outline, and pixels within it that fail the
/// gate have their class's colour. Where rings meet, the severest class is seen. On the threads of the
/// surrounding tbb::task_arena.
Plane<Rgb8> view_picture(const Plane<PixelClass>& classes, const ColourAt& colour_at);

}  // namespace zproof
