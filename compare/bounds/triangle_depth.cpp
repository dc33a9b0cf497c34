#include "compare/bounds/triangle_depth.h"

namespace zproof {

TriangleInView::TriangleInView(const ViewRay<double>& first_pixel, const ViewBounds& any_bounds,
                               const CornersWorld& p_world)
    : extent(any_bounds.extent_of(p_world)) {
    const auto plane = inverse_depth_of(first_pixel, corners<double>(p_world));
    is_edge_on = !plane;
    if (is_edge_on) return;
    inverse_depth = *plane;
    gradient = std::abs(inverse_depth.a) + std::abs(inverse_depth.b);
    own_error = PlaneError(extent.size.plane).at(any_bounds.largest_in_image(inverse_depth));
}

TriangleDepth::TriangleDepth(const TriangleInView& triangle, const ViewBounds& of_view)
    : inverse_depth_(triangle.inverse_depth),
      gradient_(triangle.gradient),
      own_error_(triangle.own_error),
      projection_(of_view.projection()),
      has_plane_(!triangle.is_edge_on && std::isfinite(own_error_)),
      is_edge_on_(triangle.is_edge_on) {
    const TriangleBounds bounds = of_view.of(triangle.extent);
    bounds_ = BoundsOnPlane(bounds, gradient_);
    nearest_ = bounds.nearest;
    farthest_ = bounds.farthest;
    least_depth_ = of_view.keeps_to_corners() ? nearest_ : -unlimited;
    greatest_depth_ = of_view.keeps_to_corners() ? farthest_ : unlimited;
}

DepthBound TriangleDepth::at(int x, int y) const {
    if (!has_plane_) return rounded({nearest_, nearest_, farthest_, bounds_.at(inverse_depth_.at(x, y))});
    return rounded(projection_ == Projection::perspective ? on_plane<Projection::perspective>(x, y)
                                                          : on_plane<Projection::parallel>(x, y));
}

}  // namespace zproof
