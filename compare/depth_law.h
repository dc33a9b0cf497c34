/// Depths along rows of pixels held against the bounds of the triangles that they show: the way of most
/// pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "compare/tile_row.h"
#include "frame/frame.h"
#include "scenes/view.h"

namespace zproof {

/// What TriangleDepth::at and certainly_holds need of one triangle and one renderer, as plain numbers. Only
/// for triangles whose plane and depth errors are finite; where a renderer does not keep to its corners'
/// depths, `nearest` and `farthest` are infinite.
struct DepthLaw {
    double nearness_per_x = 0, nearness_per_y = 0, nearness_offset = 0;  ///< of pixel indices
    double gradient = 0, own_error = 0;
    double least = 0, highest = 0;                          ///< nearness
    double base = 0, per = 0, most = 0, amplification = 0;  ///< of BoundsOnPlane's depth_eps_px
    double depth_factor = 0, plane_offset = 0, absolute = 0, nearness_error = 0;
    double nearest = 0, farthest = 0;
};

/// A ratio that says: ask for this pixel by itself.
inline constexpr double unsettled = -1;

/// A law by which every depth is unsettled.
inline constexpr DepthLaw law_of_nothing{.depth_factor = 1};

/// 64 pixels of a row, as both frames show them, on their way through the first pass.
struct Strip {
    static constexpr std::size_t width = 64;
    template <class T>
    using Values = std::array<T, width>;

    /// What one renderer shows.
    struct Side {
        Values<PrimitiveId> primitive;
        Values<float> camera_depth;
        Values<std::uint32_t> law;  ///< of the triangle: a place among the laws
        Values<double> ratio;       ///< error / bound, or `unsettled`
        Values<std::int32_t>
            bin;  ///< of the ratio, as BoundHistogram has it; `uncounted` where not both are settled
    };
    static constexpr std::int32_t uncounted = 21;

    int x = 0, y = 0;  ///< of the first
    Side candidate, reference;
    Values<std::uint32_t> is_open;  ///< to be looked at by itself: neither settled nor bare in both frames
};

/// Fills in the ratios: the same bits as TriangleDepth::at followed by error_over_bound, or `unsettled` where
/// double precision does not hold the depth lawful for certain.
void hold_perspective(std::span<const DepthLaw> laws, int x, int y, Strip::Side& side);
void hold_parallel(std::span<const DepthLaw> laws, int x, int y, Strip::Side& side);

/// Depths along a row held against one law: TriangleDepth::at and, as above, the ratio.
struct DepthRow {
    TileRow low, truth, high, ratio;
};
DepthRow depths_in_row(const DepthLaw& law, Projection projection, const RowPlace& row,
                       const TileRowOf<float>& camera_depth);

/// The largest ratios that were counted, side by side.
using Largest = std::array<double, 8>;

/// Fills in bins and is_open, and raises the largest.
void sort_out(Strip& strip, Largest& candidate, Largest& reference);

}  // namespace zproof
