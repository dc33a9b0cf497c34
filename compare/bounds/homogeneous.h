/// What rounding costs a rasterizer whose edge functions take corners before the divide (Olano and Greer
/// 1997; docs/bounds.md, "Edge functions").
#pragma once

#include <array>

#include "compare/bounds/triangle_extent.h"
#include "compare/bounds/view_facts.h"
#include "compare/bounds/z_range.h"

namespace zproof {

struct HomogeneousBounds {
    std::array<double, 3> edges_px{};  ///< of its edges, at most across the image
    double inverse_depth_error = 0;    ///< of what is interpolated by edge functions over the determinant
    double depth_factor = 0;           ///< of the determinant
};

/// `moved` is how far the matrices move corners along the camera's axes, `z` what is interpolated, `unit`
/// that of the edge functions.
HomogeneousBounds homogeneous_bounds(const ViewFacts& facts, const TriangleExtent& extent,
                                     const glm::dvec3& moved, const ZRange& z, double unit);

}  // namespace zproof
