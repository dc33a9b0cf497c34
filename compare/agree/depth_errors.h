/// Depths along a run of pixels held against one triangle's bound, side by side.
#pragma once

#include <cstddef>

#include "compare/bounds/triangle_depth.h"

namespace zproof {

/// Says of a pixel that double precision does not hold its depth admissible for certain.
inline constexpr double undecided_error = -1;

/// Errors are found for so many pixels at a time.
inline constexpr std::size_t errors_together = 4;

/// Writes error / bound, or undecided_error, of `count` pixels (x, y), (x + 1, y) ... that show the triangle.
/// Up to the next multiple of errors_together, depths are read and errors are written beyond them. Other
/// depths at the same pixels, if any, are held against the same bounds.
void find_depth_errors(const TriangleDepth& triangle, int x, int y, std::size_t count, const float* depths,
                       double* errors, const float* other_depths = nullptr, double* other_errors = nullptr);

}  // namespace zproof
