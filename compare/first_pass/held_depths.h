/// Depths along rows of pixels held against the bounds of the triangles that they show: the way of most
/// pixels.
#pragma once

#include <array>

#include "compare/bounds/depth_law.h"
#include "compare/strips/strip.h"
#include "scenes/view.h"

namespace zproof {

/// Fills in the ratios, where the pixels are not sorted yet: the same bits as TriangleDepth::at followed by
/// error_over_bound, or `unsettled` where double precision does not hold the depth lawful for certain.
void hold_perspective(const LawsOfBoth& laws, const Strip& strip, const LawsAlong& along, SortedStrip& held);
void hold_parallel(const LawsOfBoth& laws, const Strip& strip, const LawsAlong& along, SortedStrip& held);

/// Depths along a row held against one law: TriangleDepth::at and, as above, the ratio.
struct DepthRow {
    TileRow low, truth, high, ratio;
};
DepthRow depths_in_row(const DepthLaw& law, Projection projection, const RowPlace& row,
                       const TileRowOf<float>& camera_depth);

/// The largest ratios that were counted, side by side.
using Largest = std::array<double, 8>;

/// Fills in what is open, where the pixels are not sorted yet, and raises the largest.
void sort_out(const Strip& strip, SortedStrip& held, Largest& candidate, Largest& reference);

}  // namespace zproof
