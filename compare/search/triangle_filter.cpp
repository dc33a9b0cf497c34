#include "compare/search/triangle_filter.h"

#include <algorithm>

#include "compare/bounds/triangle_image.h"
#include "math/rounding.h"

namespace zproof {

namespace {

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The normal from sides in world space, so that its rounding is relative to the sides, not to the distance.
Vector3<double> normal_of(const CornersWorld& p) {
    const auto a = exactly<double>(glm::dvec3(p[0])), b = exactly<double>(glm::dvec3(p[1])),
               c = exactly<double>(glm::dvec3(p[2]));
    return cross(b - a, c - a);
}

}  // namespace

TriangleFilters::TriangleFilters(const View& view)
    : boxes_(view),
      any_bounds_(view, RasterPrecision{}),
      sight_(view, 0, 0),
      width_(view.width),
      height_(view.height),
      perspective_(view.camera.projection == Projection::perspective) {
    const Camera& c = view.camera;
    const double u = std::max(std::abs(c.window.left), std::abs(c.window.right));
    const double v = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    const double on_plane = u * size_of(c.right) + v * size_of(c.up);
    const double sheared = std::abs(c.shear.x) * size_of(c.right) + std::abs(c.shear.y) * size_of(c.up);
    origin_size_ = size_of(glm::dvec3(c.eye_world)) + on_plane;
    direction_size_ = (perspective_ ? on_plane : sheared) + size_of(c.back);
}

/// Of each corner as seen from the origin of sight, every term in absolute value.
std::array<double, 3> TriangleFilters::corner_sizes(const CornersWorld& p_world) const {
    const glm::dvec3 eye(sight_.origin.x, sight_.origin.y, sight_.origin.z);
    const auto size = [&](const glm::vec3& p) {
        return perspective_ ? size_of(glm::dvec3(p) - eye) : size_of(glm::dvec3(p)) + origin_size_;
    };
    return {size(p_world[0]), size(p_world[1]), size(p_world[2])};
}

TriangleFilter TriangleFilters::of(const ViewedTriangle& triangle) const {
    TriangleFilter filter = by_functionals(triangle);
    const std::optional<CornerBoxes> corners = boxes_.of_corners(triangle.p_world);
    if (corners)
        filter.box = corners->all();
    else if (const auto box = boxes_(triangle.p_world))
        filter.box = *box;
    if (corners && !filter.is_trusted) filter.hull.emplace(*corners);
    return filter;
}

TriangleImage<double> TriangleFilters::parallel_image(const CornersWorld& p_world,
                                                      const Vector3<double>& normal, double facing) const {
    const Corners<double> p = corners<double>(p_world);
    const Vector3<double> v0 = p[0] - sight_.origin, v1 = p[1] - sight_.origin, v2 = p[2] - sight_.origin;
    const TriangleImage<double> image{
        .edge = {detail::parallel_edge(sight_, v1, v2), detail::parallel_edge(sight_, v2, v0),
                 detail::parallel_edge(sight_, v0, v1)},
        .nearness = (-1 / facing) * Affine<double>{-dot(normal, sight_.step_x), -dot(normal, sight_.step_y),
                                                   dot(normal, v0)}};
    return detail::oriented(image, sign(facing));
}

TriangleFilter TriangleFilters::by_functionals(const ViewedTriangle& triangle) const {
    TriangleFilter filter;
    if (!triangle.plane_error.is_known()) return filter;
    const Vector3<double> normal = normal_of(triangle.p_world);
    const Corners<double> p = corners<double>(triangle.p_world);
    double facing = 0;
    if (perspective_) {
        const auto image = triangle.image.at_any();
        if (!image) return filter;
        facing = dot(p[0] - sight_.origin, normal);
        filter.edge = image->edge;
        filter.nearness = (1 / facing) * detail::perspective_functional(sight_, normal);
    } else {
        facing = dot(normal, sight_.direction);
        const TriangleImage<double> image = parallel_image(triangle.p_world, normal, facing);
        filter.edge = image.edge;
        filter.nearness = image.nearness;
    }
    // each of five terms is below V V' D and has at most 40 roundings; once for us, once for image_of
    static const double share = 2 * 5 * gamma(40, unit_roundoff_float64);
    const auto [v0, v1, v2] = corner_sizes(triangle.p_world);
    const double d = direction_size_, largest = std::max({v0, v1, v2}), rounding = share * largest * largest;
    filter.edge_error = {share * v1 * v2 * d, share * v2 * v0 * d, share * v0 * v1 * d};
    const Affine<double>& n = filter.nearness;
    filter.nearness_error =
        2 * triangle.plane_error.at(std::abs(n.c) + std::abs(n.a) * width_ + std::abs(n.b) * height_);
    filter.is_trusted =
        std::isfinite(filter.nearness_error) && std::abs(facing) > rounding * (perspective_ ? largest : d);
    return filter;
}

}  // namespace zproof
