/// Depths along rows of pixels held against the bounds of the triangles that they show: the way of most
/// pixels.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "compare/strip.h"
#include "scenes/view.h"

namespace zproof {

/// What TriangleDepth::at and certainly_holds need of one triangle and one renderer, as plain numbers. Only
/// for triangles whose plane and depth errors are finite; where a renderer does not keep to its corners'
/// depths, `nearest` and `farthest` are infinite.
template <class Number>
struct DepthLawOf {
    Number nearness_per_x, nearness_per_y, nearness_offset;  ///< of pixel indices
    Number gradient, own_error;
    Number least, highest;                  ///< nearness
    Number base, per, most, amplification;  ///< of a Displacement
    Number depth_factor, plane_offset, absolute, nearness_error;
    Number relative;  ///< of depth, where plane_offset is 0: depth_factor compounded
    Number nearest, farthest;
};
using DepthLaw = DepthLawOf<double>;

/// A ratio that says: ask for this pixel by itself.
inline constexpr double unsettled = -1;

/// A law by which every depth is unsettled.
inline constexpr DepthLaw law_of_nothing = [] {
    DepthLaw law{};
    law.depth_factor = 1;
    law.relative = std::numeric_limits<double>::infinity();
    return law;
}();

/// The laws of the same triangles for both renderers, by place. What both laws of a triangle say of its plane
/// is the same.
struct LawsOfBoth {
    std::vector<DepthLaw> candidate, reference;
};

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
