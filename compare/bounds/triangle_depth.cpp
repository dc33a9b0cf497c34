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
    : inverse_depth_(triangle.inverse_depth), gradient_(triangle.gradient), own_error_(triangle.own_error) {
    const DepthTerms terms = of_view.depth_terms(triangle.extent);
    const ViewBounds::CornerDepths corners = of_view.corner_depths(triangle.extent);
    corners_ = CornerInverseDepth(corners.nearest, corners.farthest);
    eps_px_ = Displacement(terms.eps_base_px, terms.eps_per_inverse_depth, gradient_, corners_.highest);
    factor_ = terms.factor;
    plane_offset_ = terms.plane_offset;
    relative_ = compounded(terms.factor) + terms.share;
    absolute_ = terms.absolute;
    inverse_depth_error_ = terms.inverse_depth_error;
    inverse_depth_bias_ = terms.inverse_depth_bias;
    nearest_ = corners.nearest;
    farthest_ = corners.farthest;
    least_depth_ = of_view.keeps_to_corners() ? nearest_ : -unlimited;
    greatest_depth_ = of_view.keeps_to_corners() ? farthest_ : unlimited;
    projection_ = of_view.projection();
    is_edge_on_ = triangle.is_edge_on;
    has_plane_ = !is_edge_on_ && std::isfinite(own_error_);
}

auto TriangleDepth::range_at(double x, double y) const -> UnroundedDepth {
    using enum Projection;
    using enum Relative;
    const bool is_perspective = projection_ == perspective;
    if (has_plane_ && relative() == constant)
        return is_perspective ? on_plane<perspective, constant>(x, y) : on_plane<parallel, constant>(x, y);
    if (has_plane_)
        return is_perspective ? on_plane<perspective, by_inverse_depth>(x, y)
                              : on_plane<parallel, by_inverse_depth>(x, y);
    const double here = held_between(inverse_depth_.at(x, y), corners_.least, corners_.highest);
    return {nearest_, nearest_, farthest_,
            relative() == constant ? relative_ : relative_at<by_inverse_depth>(here)};
}

}  // namespace zproof
