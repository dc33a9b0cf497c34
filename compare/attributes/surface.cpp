#include "compare/attributes/surface.h"

#include <algorithm>
#include <cmath>

namespace zproof {

std::optional<Surface> surface_at(const ViewFacts& facts, const ViewBounds& bounds,
                                  const CornersWorld& p_world, const PixelCoord& pixel) {
    const ViewRay<double> ray(facts.view, pixel.x, pixel.y);
    const TriangleExtent extent = bounds.extent_of(p_world);
    const BoundedTriangle triangle(bounds, p_world, extent);
    Surface s{facts, pixel, ray, extent, triangle.bounds, neighbour_of(ray, triangle)};
    if (!s.seen.image || !s.seen.is_plane_known) return std::nullopt;
    const double half_side = s.seen.bounds.depth_eps_px;
    double sum = 0, sum_abs = 0, steepness = 0;
    for (const Affine<double>& edge : s.seen.image->edge) {
        sum += edge.c;
        sum_abs += std::abs(edge.c) + s.seen.edge_error;
        steepness += std::abs(edge.a) + std::abs(edge.b);
    }
    s.least_sum = sum - half_side * steepness - 3 * s.seen.edge_error;
    s.spread = std::max(1.0, (sum_abs + half_side * steepness) / s.least_sum);
    s.least_inverse_depth = s.seen.image->inverse_depth.c - half_side * s.seen.gradient - s.seen.plane_error;
    return s.least_sum > 0 ? std::optional(s) : std::nullopt;
}

}  // namespace zproof
