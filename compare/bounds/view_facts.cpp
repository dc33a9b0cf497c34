#include "compare/bounds/view_facts.h"

#include <algorithm>
#include <cmath>

#include "math/rounding.h"

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

Gauge gauge_of(const Camera& c, const glm::dvec3& direction_abs, const glm::dvec3& origin_abs) {
    const glm::dvec3 eye(c.eye_world);
    const auto all = [](const glm::dvec3& v) { return exactly<double>(v); };
    return {.projection = c.projection,
            .eye = all(eye),
            .eye_abs = all(glm::abs(eye)),
            .back = all(c.back),
            .axes_abs = {all(glm::abs(c.right)), all(glm::abs(c.up)), all(glm::abs(c.back))},
            .direction = all(c.shear.x * c.right + c.shear.y * c.up - c.back),
            .direction_abs = all(direction_abs),
            .origin_abs = all(origin_abs)};
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
    gauge = gauge_of(c, direction_abs, origin_abs);
}

TriangleExtent ViewFacts::extent_of(const CornersWorld& p_world) const {
    const glm::dvec3 p[] = {glm::dvec3(p_world[0]), glm::dvec3(p_world[1]), glm::dvec3(p_world[2])};
    const glm::dvec3 eye(view.camera.eye_world);
    return {{p[0] - eye, p[1] - eye, p[2] - eye},
            gauge({exactly<double>(p[0]), exactly<double>(p[1]), exactly<double>(p[2])})};
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
