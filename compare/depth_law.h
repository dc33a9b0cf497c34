/// Depths along rows of pixels held against the bounds of the triangles that they show: the way of most
/// pixels.
#pragma once

#include <cstdint>
#include <span>

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

/// Pixels of a row, from (x, y) on. Their number is a multiple of `together`.
struct RowOfDepths {
    static constexpr std::size_t together = 8;

    int x = 0, y = 0;
    std::span<const std::uint32_t> law;  ///< of each pixel: a place among the laws
    const float* depth = nullptr;
};

/// Writes error / bound for each pixel of the row, or `unsettled` where double precision does not hold the
/// depth lawful for certain. The same bits as TriangleDepth::at followed by error_over_bound.
void hold_perspective(std::span<const DepthLaw> laws, const RowOfDepths& row, double* ratio);
void hold_parallel(std::span<const DepthLaw> laws, const RowOfDepths& row, double* ratio);

/// Bins of error / bound as BoundHistogram has them, and one for what is unsettled.
inline constexpr std::int32_t ratio_bins = 21, unsettled_bin = ratio_bins;

/// The bin of each ratio, and of each `also` at the same place; both unsettled_bin where either is unsettled
/// or `counts` is 0. Raises most[i % together] and most_also[i % together] to the ratios that are binned.
struct PairOfRatios {
    std::span<const double> one, also;
    std::span<const std::uint32_t> counts;
};
struct PairOfBins {
    std::int32_t *one, *also;
    double *most_of_one, *most_of_also;
};
void bin_ratios(const PairOfRatios& ratios, const PairOfBins& bins);

}  // namespace zproof
