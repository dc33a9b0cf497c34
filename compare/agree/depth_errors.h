/// Depths along a run of pixels held against one triangle's bound, side by side.
#pragma once

#include <span>

#include "compare/bounds/triangle_depth.h"

namespace zproof {

/// Says of a pixel that double precision does not hold its depth admissible for certain.
inline constexpr double undecided_error = -1;

/// Writes error / bound, or undecided_error, of pixels (x, y), (x + 1, y) ... that show the triangle. `errors` has as
/// many places as there are depths.
void find_depth_errors(const TriangleDepth& triangle, int x, int y, std::span<const float> depths, double* errors);

}  // namespace zproof
