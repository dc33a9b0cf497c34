/// Depth as a renderer has it that forgets the perspective: interpolated linearly over the raster image.
#pragma once

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// What such a renderer may report for a triangle at a pixel, with the triangle's own bounds there. Clipping
/// adds corners, and from which three of them depth is interpolated is the renderer's choice: the range
/// holds every choice.
ReportedDepth affine_depth(const View& view, int x, int y, const Neighbour& triangle);

}  // namespace zproof
