#include "compare/bounds/view_facts.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/roundings.h"

namespace zproof {

namespace {

double largest_defect(const Camera& camera) {
    const glm::dmat3 axes(camera.right, camera.up, camera.back);
    const glm::dmat3 gram = glm::transpose(axes) * axes;
    double defect = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) defect = std::max(defect, std::abs(gram[i][j] - (i == j)));
    return defect + gamma(4, unit_roundoff_float64);
}

}  // namespace

ViewFacts::ViewFacts(const View& of_view)
    : view(of_view),
      perspective(of_view.camera.projection == Projection::perspective),
      orthonormality(largest_defect(of_view.camera)) {
    const Camera& c = view.camera;
    largest_u = std::max(std::abs(c.window.left), std::abs(c.window.right));
    largest_v = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    scale = {.px_per_u = view.width / (c.window.right - c.window.left),
             .px_per_v = view.height / (c.window.top - c.window.bottom),
             .slant_u = perspective ? largest_u : std::abs(c.shear.x),
             .slant_v = perspective ? largest_v : std::abs(c.shear.y)};
    direction_abs = scale.slant_u * glm::abs(c.right) + scale.slant_v * glm::abs(c.up) + glm::abs(c.back);
    start = perspective ? 0 : std::max(-c.near_depth, 0.0);
    origin_abs = perspective
                     ? glm::dvec3(0)
                     : largest_u * glm::abs(c.right) + largest_v * glm::abs(c.up) + start * direction_abs;
    right_per_px = 1 / scale.px_per_u * c.right;
    up_per_px = 1 / scale.px_per_v * c.up;
}

TriangleExtent ViewFacts::extent_of(const CornersWorld& p_world) const {
    const Camera& c = view.camera;
    const glm::dvec3 eye(c.eye_world);
    const glm::dvec3 eye_abs = abs(eye), right_abs = abs(c.right), up_abs = abs(c.up), back_abs = abs(c.back);
    const auto along_axes = [&](const glm::dvec3& v) {
        return glm::dvec3(dot(right_abs, v), dot(up_abs, v), dot(back_abs, v));
    };
    TriangleExtent extent;
    TriangleSize& size = extent.size;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p(p_world[i]), v = p - eye;
        extent.v_world[i] = v;
        size.depth[i] = -dot(c.back, v);
        size.from_eye = max(size.from_eye, along_axes(abs(v) + origin_abs));
        size.from_origin = max(size.from_origin, along_axes(abs(p) + eye_abs));
    }
    size.plane = plane_size(extent.v_world[0], p_world);
    return extent;
}

PlaneSize ViewFacts::plane_size(const glm::dvec3& v0, const CornersWorld& p_world) const {
    const glm::dvec3 p0(p_world[0]), e1 = glm::dvec3(p_world[1]) - p0, e2 = glm::dvec3(p_world[2]) - p0,
                                     normal = cross(e1, e2);
    const glm::dvec3 normal_abs = abs_cross(e1, e2) + abs_cross(e1, e2 - e1) + abs_cross(e2, e2 - e1);
    const double from_corner = dot(abs(v0) + origin_abs, normal_abs),
                 along_ray = dot(direction_abs, normal_abs);
    if (perspective) return {std::abs(dot(v0, normal)), from_corner, along_ray, 0};
    const glm::dvec3 eye_abs = abs(glm::dvec3(view.camera.eye_world));
    return {std::abs(dot(direction(), normal)), along_ray, from_corner,
            gamma(6, unit_roundoff_float64) * dot(eye_abs + origin_abs, normal_abs)};
}

double ViewFacts::distance_px(double error, const glm::dvec3& moment) const {
    const double along = std::abs(glm::dot(moment, right_per_px)) + std::abs(glm::dot(moment, up_per_px));
    return along > 0 ? error / along : 0;  // without extent it bounds no area
}

glm::dvec2 ViewFacts::before_divide(const TriangleExtent& extent, std::size_t corner) const {
    const Camera& c = view.camera;
    const double depth = extent.size.depth[corner];
    return {glm::dot(c.right, extent.v_world[corner]) - c.shear.x * depth,
            glm::dot(c.up, extent.v_world[corner]) - c.shear.y * depth};
}

}  // namespace zproof
