#include "compare/bounds/triangle_depth.h"

namespace zproof {

TriangleInView::TriangleInView(const Sight<double>& first_pixel, const ViewBounds& any_bounds,
                               const CornersWorld& p_world)
    : extent(any_bounds.extent_of(p_world)) {
    const auto plane = nearness_of(first_pixel, corners<double>(p_world));
    is_edge_on = !plane;
    if (is_edge_on) return;
    nearness = *plane;
    gradient = std::abs(nearness.a) + std::abs(nearness.b);
    own_error = PlaneError(extent.size.plane).at(any_bounds.largest_in_image(nearness));
}

TriangleDepth::TriangleDepth(const TriangleInView& triangle, const ViewBounds& of_view)
    : nearness_(triangle.nearness), gradient_(triangle.gradient), own_error_(triangle.own_error) {
    const DepthTerms terms = of_view.depth_terms(triangle.extent);
    const ViewBounds::CornerDepths corners = of_view.corner_depths(triangle.extent);
    corners_ = CornerNearness(corners.nearest, corners.farthest);
    eps_px_ = Displacement(terms.eps_base_px, terms.eps_per_nearness, gradient_, corners_.highest);
    factor_ = terms.factor;
    plane_offset_ = terms.plane_offset;
    relative_ = compounded(terms.factor);
    absolute_ = terms.absolute;
    nearness_error_ = terms.nearness_error;
    nearest_ = corners.nearest;
    farthest_ = corners.farthest;
    least_depth_ = of_view.keeps_to_corners() ? nearest_ : -unlimited;
    greatest_depth_ = of_view.keeps_to_corners() ? farthest_ : unlimited;
    projection_ = of_view.projection();
    is_edge_on_ = triangle.is_edge_on;
    has_plane_ = !is_edge_on_ && std::isfinite(own_error_);
}

auto TriangleDepth::range_at(double x, double y) const -> Range {
    using enum Projection;
    using enum Relative;
    const bool is_perspective = projection_ == perspective;
    if (has_plane_ && relative() == everywhere)
        return is_perspective ? on_plane<perspective, everywhere>(x, y)
                              : on_plane<parallel, everywhere>(x, y);
    if (has_plane_)
        return is_perspective ? on_plane<perspective, by_nearness>(x, y)
                              : on_plane<parallel, by_nearness>(x, y);
    const double here = held_between(nearness_.at(x, y), corners_.least, corners_.highest);
    return {nearest_, nearest_, farthest_,
            relative() == everywhere ? relative_ : relative_at<by_nearness>(here)};
}

}  // namespace zproof
