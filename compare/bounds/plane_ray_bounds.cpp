#include "compare/bounds/plane_ray_bounds.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/roundings.h"

namespace zproof {

namespace {

/// The largest sum of coordinates of a point or origin that the arithmetic meets.
double ray_reach(const ViewFacts& facts, const TriangleExtent& extent) {
    double reach = 0;
    for (const glm::dvec3& v : extent.v_world) reach = std::max(reach, sum_abs(v));
    if (facts.perspective) return reach;
    const Camera& c = facts.view.camera;
    const double start = 3 * std::max(std::abs(c.near_depth), std::abs(c.far_depth)) +
                         (c.window.right - c.window.left) + (c.window.top - c.window.bottom);
    return reach + sum_abs(facts.origin_abs) + start * sum_abs(facts.direction_abs);
}

/// How far a point that a ray met may seem to lie from where it is on its triangle, scene units.
double plane_test_error(const ViewFacts& facts, const TriangleExtent& extent,
                        const PlaneRayPrecision& precision) {
    constexpr double u = unit_roundoff_float64, sqrt3 = 1.7320508075688773;
    const auto& v = extent.v_world;
    const glm::dvec3 side1 = v[0] - v[1], side2 = v[2] - v[1];
    const double product = glm::length(side1) * glm::length(side2);
    const double area = glm::length(glm::cross(side1, side2));
    const double sine = product > 0 ? std::max(area / product, precision.least_corner_sine) : 1;
    const double diameter = std::max({glm::length(side1), glm::length(side2), glm::length(v[2] - v[0])});
    const double reach = ray_reach(facts, extent);
    const double offset = sqrt3 * gamma(5, u) / sine * diameter + gamma(8, u) * reach;
    const double error = sqrt3 * (offset + gamma(2, u) * reach + 3 * gamma(3, u) * diameter);
    const bool may_graze = extent.size.plane.volume <= 2 * precision.least_grazing_sine * area * reach;
    return error + (may_graze ? precision.least_grazing_sine * reach : 0);
}

}  // namespace

PlaneRayBounds::PlaneRayBounds(const ViewFacts& facts, const PlaneRayPrecision& precision)
    : precision_(precision),
      aim_(facts, gamma(24, unit_roundoff_float64), gamma(24, unit_roundoff_float64),
           precision.aim_offset_px) {}

TriangleBounds PlaneRayBounds::of(const ViewFacts& facts, const TriangleExtent& extent) const {
    constexpr double u = unit_roundoff_float64;
    const double corner = u * facts.scale.lateral_px(extent.size.from_eye);
    const double inside = facts.scale.lateral_px(glm::dvec3(plane_test_error(facts, extent, precision_)));
    const double aim = aim_.at_depth_px(extent.size.largest_depth());

    TriangleBounds bounds;
    bounds.eps_base_px = aim + (facts.perspective ? 0 : corner + inside);
    bounds.eps_per_inverse_depth = facts.perspective ? corner + inside : 0;
    bounds.depth_eps_base_px = aim + (facts.perspective ? 0 : corner);
    bounds.depth_eps_per_inverse_depth = facts.perspective ? corner : 0;

    // where the ray meets the plane as for Pluecker rays, the normal's length taken out: 10 roundings in each
    // product; then -back . (origin + t d)
    const Camera& c = facts.view.camera;
    const PlaneSize& size = extent.size.plane;
    const auto over_volume = [&](double sum) {
        return size.volume > 0 ? gamma(10, u) * sum / size.volume : unlimited;
    };
    const double volume_factor = over_volume(size.volume_abs),
                 numerator_error = over_volume(size.numerator_abs);
    const double along = gamma(8, u) * glm::dot(glm::abs(c.back), facts.direction_abs) +
                         facts.orthonormality * (1 + facts.scale.slant_u + facts.scale.slant_v);
    const double hit_factor = gamma(8, u) + aim_.depth_relative + volume_factor + along;
    bounds.depth_factor = hit_factor + precision_.depth_relative;
    bounds.depth_absolute = u * extent.size.from_eye.z + aim_.depth_absolute;
    if (facts.perspective) {
        bounds.plane_offset = numerator_error;
    } else {
        bounds.depth_absolute +=
            numerator_error * (1 + compounded(volume_factor)) +
            (gamma(8, u) * sum_abs(c.back) + facts.orthonormality) * ray_reach(facts, extent);
    }
    const auto slack = [&](double plane_depth) {
        const double share = compounded(hit_factor + bounds.plane_offset * plane_depth);
        if (std::isinf(share)) return share;
        const double clip = precision_.clip_relative * std::abs(plane_depth) +
                            (facts.perspective ? 0 : precision_.clip_of_reach * ray_reach(facts, extent));
        return std::abs(plane_depth) * share + bounds.depth_absolute + clip;
    };
    bounds.near_slack = slack(c.near_depth);
    bounds.far_slack = std::isfinite(c.far_depth) ? slack(c.far_depth) : 0;
    if (!facts.perspective) bounds.depth_absolute += precision_.depth_of_range * (c.far_depth - c.near_depth);
    return bounds;
}

}  // namespace zproof
