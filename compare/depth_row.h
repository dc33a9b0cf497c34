/// Depths along a row of pixels that show one triangle, held against their bounds: the way of most pixels.
#pragma once

#include <span>

namespace zproof {

/// What TriangleDepth::at and certainly_holds need along one row, as plain numbers. Only for triangles whose
/// plane and depth errors are finite; where a renderer does not keep to its corners' depths, `nearest` and
/// `farthest` are infinite.
struct DepthRow {
    double nearness_step, nearness_row, nearness_offset;  ///< nearness = step x + row + offset
    double gradient, own_error;
    double least, highest;                  ///< nearness
    double base, per, most, amplification;  ///< of BoundsOnPlane's depth_eps_px
    double depth_factor, plane_offset, absolute, nearness_error;
    double nearest, farthest;
};

/// A ratio that says: ask for this pixel by itself.
inline constexpr double unsettled = -1;

/// Writes error / bound for pixels (first_x + i) of the row, or `unsettled` where double precision does not
/// hold the depth lawful for certain. The same bits as TriangleDepth::at followed by error_over_bound.
void hold_perspective_row(const DepthRow& row, int first_x, std::span<const float> depth, double* ratio);
void hold_parallel_row(const DepthRow& row, int first_x, std::span<const float> depth, double* ratio);

}  // namespace zproof
