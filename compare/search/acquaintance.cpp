#include "compare/search/acquaintance.h"

namespace zproof {

namespace {

/// The nearness of a plane moved inwards by its slack, as AdmissibleSet has it; what no triangle keeps to
/// where nothing of it is left.
double near_limit(const Camera& c, double slack) {
    const double depth = c.near_depth + slack;
    if (std::isinf(depth)) return -unlimited;
    return c.projection == Projection::perspective ? 1 / depth : -depth;
}
double far_limit(const Camera& c, double slack) {
    const double depth = c.far_depth - slack;
    const bool perspective = c.projection == Projection::perspective;
    if (depth <= (perspective ? 0 : -unlimited)) return unlimited;
    if (std::isinf(depth)) return -unlimited;
    return perspective ? 1 / depth : -depth;
}

}  // namespace

void expect_corners(const Scene& scene, std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) __builtin_prefetch(&scene.triangles[t]);
    for (const std::uint32_t t : triangles)
        for (int corner = 0; corner < 3; ++corner)
            __builtin_prefetch(&scene.vertices.position_world[scene.triangles[t][corner]]);
}

BoundedTriangle::BoundedTriangle(const ViewBounds& bounds, const Camera& camera,
                                 const ViewedTriangle& triangle)
    : of_view(bounds, triangle) {
    const TriangleBounds& b = of_view.bounds;
    is_never_cut = b.nearest > camera.near_depth && b.farthest < camera.far_depth;
    is_always_clear =
        b.nearest > camera.near_depth + b.near_slack && b.farthest < camera.far_depth - b.far_slack;
    most_near = near_limit(camera, b.near_slack);
    most_far = far_limit(camera, b.far_slack);
}

bool BoundedTriangle::is_clear_of_planes(const TriangleFilter& filter, const Around& box) const {
    if (is_always_clear) return true;
    if (!filter.is_trusted) return false;
    const double middle = filter.nearness.at(box.x, box.y),
                 unsure = reach(filter.nearness, box) + filter.nearness_error;
    return middle + unsure < most_near && middle - unsure > most_far;
}

/// eps grows with nearness.
double BoundedTriangle::most_eps_px(const TriangleFilter& filter, const Around& box) const {
    const TriangleBounds& b = of_view.bounds;
    if (b.eps_per_nearness == 0) return b.eps_base_px;
    if (!of_view.on_plane) return unlimited;
    const double nearness = filter.nearness.at(box.x, box.y) + reach(filter.nearness, box);
    return of_view.on_plane->at(filter.is_trusted ? nearness + filter.nearness_error : unlimited).eps_px;
}

}  // namespace zproof
