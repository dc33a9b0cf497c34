#include "compare/attributes/surface.h"

#include <algorithm>
#include <cmath>

namespace zproof {

Surface surface_at(const ViewFacts& facts, const ViewBounds& bounds, const CornersWorld& p_world,
                   const PixelCoord& pixel) {
    const ViewRay<double> ray(facts.view, pixel.x, pixel.y);
    const TriangleExtent extent = bounds.extent_of(p_world);
    const BoundedTriangle triangle(bounds, p_world, extent);
    Surface s{facts, pixel, ray, extent, triangle.bounds, neighbour_of(ray, triangle)};
    if (!s.has_plane()) return s;
    const double half_side = s.seen.bounds.depth_eps_px;
    Affine<double> sum{0, 0, 0};
    double sum_abs = 0;
    for (const Affine<double>& edge : s.seen.image->edge) {
        sum = {sum.a + edge.a, sum.b + edge.b, sum.c + edge.c};
        sum_abs += std::abs(edge.c) + s.seen.edge_error;
    }
    // edge_error holds within a pixel of the centre; what is affine grows no faster beyond
    const double error = 3 * s.seen.edge_error;
    s.sum_at_centre = sum.c - error;
    s.least_sum = sum.c - half_side * (std::abs(sum.a) + std::abs(sum.b)) - error * std::max(1.0, half_side);
    if (s.has_centre()) s.spread_at_centre = std::max(1.0, sum_abs / s.sum_at_centre);
    s.least_inverse_depth = s.seen.image->inverse_depth.c - half_side * s.seen.gradient - s.seen.plane_error;
    return s;
}

}  // namespace zproof
