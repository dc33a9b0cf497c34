#include "compare/truth/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

double steepness(const Affine<double>& f) { return std::abs(f.a) + std::abs(f.b); }

/// By its functional of nearness at a pixel.
PlaneHere plane_here(const ViewedTriangle& triangle, const Affine<double>& nearness) {
    const double gradient = steepness(nearness);
    return {nearness.c, gradient, triangle.plane_error.at(std::abs(nearness.c) + gradient)};
}

bool is_known(const std::optional<PlaneHere>& plane) { return plane && std::isfinite(plane->error); }

LocalBounds bounds_at(const TriangleOfView& triangle, const std::optional<PlaneHere>& plane) {
    const double nearest = triangle.bounds.nearest, highest = nearest > 0 ? 1 / nearest : 0;
    return triangle.bounds_at(plane ? plane->nearness : highest, plane ? plane->gradient : 0);
}

NearnessRange nearness_range(const TriangleOfView& triangle, const std::optional<PlaneHere>& plane,
                             const LocalBounds& bounds, Projection projection) {
    const bool perspective = projection == Projection::perspective, keeps = triangle.keeps_to_corners;
    const double farthest = triangle.bounds.farthest, nearest = triangle.bounds.nearest;
    const NearnessRange corners{perspective ? 1 / farthest : -farthest, perspective ? 1 / nearest : -nearest};
    const bool is_bounded =
        std::isfinite(bounds.depth_relative + bounds.depth_absolute + bounds.nearness_error) &&
        (is_known(plane) || keeps);
    if (!is_bounded) return any_nearness;
    return rounded(plane ? on_plane(*plane, bounds, corners, keeps) : corners, bounds, perspective);
}

/// Forward error of an edge's value within a pixel of the centre: at most 16 roundings in a triple product,
/// with every difference and product in absolute value. Parallel projections round the origin of sight as
/// well.
double edge_error(const Sight<double>& sight, const CornersWorld& p_world) {
    const auto size = [](const Vector3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double steps = size(sight.step_x) + size(sight.step_y);
    const bool moves = sight.projection == Projection::parallel;
    double from_eye = 0;
    for (const Vector3<double>& p : corners<double>(p_world))
        from_eye = std::max(from_eye, moves ? size(p) + size(sight.origin) + steps : size(p - sight.origin));
    static const double share = gamma(16, unit_roundoff_float64) * 4;
    return share * from_eye * from_eye * (size(sight.direction) + steps);
}

}  // namespace

bool comes_within(const TriangleImage<double>& image, double eps_px) {
    return std::ranges::all_of(image.edge,
                               [&](const Affine<double>& e) { return e.c + eps_px * steepness(e) >= 0; });
}

std::optional<std::size_t> Neighbourhood::index_of(PrimitiveId triangle) const {
    const auto found = std::ranges::find(neighbours, std::uint32_t(triangle), &Neighbour::triangle);
    if (found == neighbours.end()) return std::nullopt;
    return std::size_t(found - neighbours.begin());
}

CornersWorld corners_of(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {p[index.x], p[index.y], p[index.z]};
}

TriangleOfView::TriangleOfView(const ViewBounds& of_view, const ViewedTriangle& triangle)
    : seen(&triangle), bounds(of_view.of(triangle.extent)), keeps_to_corners(of_view.keeps_to_corners()) {
    if (!triangle.image.is_kept()) return;
    const auto plane = triangle.image.kept_plane();
    on_plane.emplace(bounds, plane ? plane->gradient : 0);
}

double TriangleOfView::eps_px(const Sight<double>& sight) const {
    if (bounds.eps_per_nearness == 0) return bounds.eps_base_px;
    return on_plane && !seen->image.is_edge_on() ? on_plane->at(seen->image.nearness_at(sight)).eps_px
                                                 : neighbour_of(sight, *this).bounds.eps_px;
}

Neighbour neighbour_of(const Sight<double>& sight, const ViewBounds& bounds, const CornersWorld& p_world) {
    const ViewedTriangle seen(bounds, sight, p_world);
    return neighbour_of(sight, TriangleOfView(bounds, seen));
}

Neighbour neighbour_of(const Sight<double>& sight, const TriangleOfView& triangle) {
    Neighbour n;
    n.p_world = triangle.seen->p_world;
    n.image = triangle.seen->image.at(sight);
    std::optional<PlaneHere> plane;
    if (n.image) {
        plane = plane_here(*triangle.seen, n.image->nearness);
        n.gradient = plane->gradient;
        n.plane_error = plane->error;
        n.is_plane_known = is_known(plane);
        n.edge_error = edge_error(sight, n.p_world);
    }
    n.bounds = bounds_at(triangle, plane);
    const TriangleBounds& of_triangle = triangle.bounds;
    n.near_slack = of_triangle.near_slack;
    n.far_slack = of_triangle.far_slack;
    n.nearest = of_triangle.nearest;
    n.farthest = of_triangle.farthest;
    const NearnessRange range = nearness_range(triangle, plane, n.bounds, sight.projection);
    n.least_nearness = range.least;
    n.greatest_nearness = range.greatest;
    return n;
}

NearnessRange nearness_range_of(const Sight<double>& sight, const TriangleOfView& triangle) {
    std::optional<PlaneHere> plane;
    if (const auto nearness = triangle.seen->image.nearness(sight))
        plane = plane_here(*triangle.seen, *nearness);
    return nearness_range(triangle, plane, bounds_at(triangle, plane), sight.projection);
}

Neighbourhood neighbourhood_of(const Scene& scene, const View& view, const ViewBounds& bounds,
                               const Site& site, double own_eps_px) {
    const Sight<double> any(view, site.x, site.y);
    std::optional<ViewedTriangle> seen;
    std::optional<TriangleOfView> latest;
    return neighbourhood_of(view, site, own_eps_px, [&](std::uint32_t triangle) -> const TriangleOfView& {
        return latest.emplace(bounds, seen.emplace(bounds, any, corners_of(scene, triangle)));
    });
}

Neighbourhood neighbourhood_of(const View& view, const Site& site, double own_eps_px,
                               const TriangleLookUp& triangle_of_view) {
    const Sight<double> sight(view, site.x, site.y);
    Neighbourhood n{view, site.x, site.y, own_eps_px, {}};
    n.neighbours.reserve(site.triangles.size());
    for (const std::uint32_t triangle : site.triangles) {
        Neighbour& last = n.neighbours.emplace_back(neighbour_of(sight, triangle_of_view(triangle)));
        last.triangle = triangle;
        if (last.image && comes_within(*last.image, own_eps_px))
            n.eps_px = std::max(n.eps_px, last.bounds.eps_px);
    }
    return n;
}

double own_eps_px(const Scene& scene, const View& view, const ViewBounds& bounds, const PixelPlace& place,
                  PrimitiveId answer) {
    if (answer == PrimitiveId::none) return bounds.background_eps_px();
    const Sight<double> sight(view, place.x, place.y);
    const ViewedTriangle seen(bounds, sight, corners_of(scene, std::uint32_t(answer)));
    return TriangleOfView(bounds, seen).eps_px(sight);
}

}  // namespace zproof
