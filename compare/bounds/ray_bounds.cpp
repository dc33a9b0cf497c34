#include "compare/bounds/ray_bounds.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/roundings.h"

namespace zproof {

namespace {

/// (difference x sum) . direction of an edge's ends, as Embree's robust test has it, off by 7 roundings, px.
double pluecker_edge_px(const ViewFacts& facts, const TriangleExtent& extent, std::size_t edge, double unit) {
    const glm::dvec3 &from = extent.v_world[(edge + 1) % 3], &to = extent.v_world[(edge + 2) % 3];
    const glm::dvec3 difference = to - from, sum = to + from;
    const glm::dvec3 sum_abs = glm::abs(sum) + 2.0 * facts.origin_abs;
    const double error = gammas_of(unit)[7] * glm::dot(abs_cross(difference, sum_abs), facts.direction_abs);
    const glm::dvec3 moment =
        facts.perspective ? glm::cross(difference, sum) : 2.0 * glm::cross(facts.direction(), difference);
    return facts.distance_px(error, moment);
}

/// The functional of the edge from v_i to v_j, half of what pluecker_edge_px() looks at: d/d(ray).
glm::dvec3 edge_moment(const ViewFacts& facts, const TriangleExtent& extent, std::size_t edge) {
    const glm::dvec3 &from = extent.v_world[(edge + 1) % 3], &to = extent.v_world[(edge + 2) % 3];
    return facts.perspective ? glm::cross(from, to) : glm::cross(facts.direction(), to - from);
}

/// What the rounded corners of Pluecker's test cost its edges, px: 2 u (|v_i| x |v_j|) . |d|, and the robust
/// test's 2 u of the sum of all three.
double pluecker_corners_px(const ViewFacts& facts, const TriangleExtent& extent, double unit) {
    const auto& v = extent.v_world;
    const double sum = glm::dot(abs_cross(v[1] - v[0], v[2] - v[0]), facts.direction_abs);
    double largest = 0;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const glm::dvec3 products = abs_cross(v[(edge + 1) % 3], v[(edge + 2) % 3]);
        const double error = 2 * unit * (glm::dot(products, facts.direction_abs) + sum);
        largest = std::max(largest, facts.distance_px(error, edge_moment(facts, extent, edge)));
    }
    return largest;
}

/// Cramer's rule with v0 as its origin: the weights of v1 and v2 are triple products, v0 has what they leave.
std::array<double, 3> moeller_trumbore_px(const ViewFacts& facts, const TriangleExtent& extent, double unit) {
    const auto& v = extent.v_world;
    const glm::dvec3 e1 = v[1] - v[0], e2 = v[2] - v[0], from_origin = glm::abs(v[0]) + facts.origin_abs;
    const auto terms = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dot(facts.direction_abs, abs_cross(a, b));
    };
    const double of_v1 = terms(e2, from_origin), of_v2 = terms(e1, from_origin), determinant = terms(e1, e2);
    const auto px = [&](std::size_t edge, double error) {
        return facts.distance_px(error, edge_moment(facts, extent, edge));
    };
    const Gammas& gammas = gammas_of(unit);
    return {px(0, gammas[10] * (of_v1 + of_v2 + determinant)), px(1, gammas[7] * of_v1),
            px(2, gammas[7] * of_v2)};
}

/// What moving each corner by up to `error` along every axis may take from PlaneSize::volume: a determinant
/// of the corners, or of both sides and the direction.
double volume_moved_by(double error, const ViewFacts& facts, const TriangleExtent& extent) {
    const auto& v = extent.v_world;
    if (!facts.perspective) {
        const glm::dvec3 e1 = v[1] - v[0], e2 = v[2] - v[0], d = facts.direction();
        return 2 * error * (sum_abs(glm::cross(d, e1)) + sum_abs(glm::cross(d, e2))) +
               8 * error * error * sum_abs(d);
    }
    double moved = 4 * error * error * error;
    for (std::size_t i = 0; i < 3; ++i)
        moved +=
            error * sum_abs(glm::cross(v[(i + 1) % 3], v[(i + 2) % 3])) + 2 * error * error * sum_abs(v[i]);
    return moved;
}

/// How much the corners' distances along the ray may differ: they are taken along the axis of the
/// direction's largest coordinate, which is at least its length / sqrt(3).
double range_of_distances(const TriangleExtent& extent) {
    double range = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 side = glm::abs(extent.v_world[(i + 1) % 3] - extent.v_world[i]);
        range = std::max({range, side.x, side.y, side.z});
    }
    return std::sqrt(3.0) * range;
}

double range_of_depths(const TriangleExtent& extent) {
    const auto [low, high] = std::ranges::minmax(extent.size.depth);
    return high - low;
}

}  // namespace

double weights_error(const RayPrecision& precision, const std::array<glm::dvec3, 3>& v,
                     const glm::dvec3& origin_abs, const glm::dvec3& direction_abs) {
    const double unit = unit_of(precision.arithmetic);
    const glm::dvec3 e1 = v[1] - v[0], e2 = v[2] - v[0], from_origin = glm::abs(v[0]) + origin_abs;
    std::array<double, 3> size;
    double sum = 0;
    switch (precision.test) {
        case RayTest::pluecker:
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 &a = v[i], &b = v[(i + 1) % 3];
                sum += dot(abs_cross(b - a, glm::abs(b + a) + 2.0 * origin_abs), direction_abs);
            }
            return gamma(7, unit) * sum / 2;
        case RayTest::moeller_trumbore:
            sum = dot(abs_cross(e1, from_origin) + abs_cross(e2, from_origin) + abs_cross(e1, e2),
                      direction_abs);
            return 2 * gamma(10, unit) * sum;
        case RayTest::woop:
            for (std::size_t i = 0; i < 3; ++i) size[i] = sum_abs(glm::abs(v[i]) + origin_abs);
            return gamma(10, unit) * 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]) *
                   sum_abs(direction_abs);
    }
    return unlimited;
}

RayBounds::RayBounds(const ViewFacts& facts, const RayPrecision& precision)
    : precision_(precision),
      unit_(unit_of(precision.arithmetic)),
      aim_(facts, precision.direction_roundings == 1 ? unit_ : gamma(precision.direction_roundings, unit_),
           unit_, precision.aim_offset_px),
      depth_absolute_(aim_.depth_absolute + depth_of_range(facts.view.camera, precision.depth_of_range)) {}

TriangleBounds RayBounds::on_plane(const ViewFacts& facts, const TriangleSize& size) const {
    // a corner is rounded once when the origin is subtracted
    const double corner = unit_ * facts.scale.lateral_px(size.from_eye),
                 aim = aim_.at_depth_px(size.largest_depth());
    // 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and the product; unlimited
    // where the plane holds the origin, but for zeros that no rounding can change
    const double where_edge_on = size.plane.volume_abs > 0 ? unlimited : 0;
    const auto over_volume = [&](double sum_abs) {
        return size.plane.volume > 0 ? gammas_of(unit_)[8] * sum_abs / size.plane.volume : where_edge_on;
    };
    const double factor = gammas_of(unit_)[4] + aim_.depth_relative,
                 volume_factor = over_volume(size.plane.volume_abs),
                 numerator_error = over_volume(size.plane.numerator_abs);
    // what is off by a share is the distance from the start; adding that rounds once more
    const double start = facts.start,
                 of_start = start > 0 ? start * compounded(factor + volume_factor + unit_) : 0;
    TriangleBounds bounds;
    bounds.eps_base_px = facts.perspective ? aim : aim + corner;
    bounds.eps_per_inverse_depth = facts.perspective ? corner : 0;
    bounds.displace_depth_alike();
    bounds.depth_factor = factor + volume_factor + (start > 0 ? unit_ : 0);
    bounds.depth_absolute = unit_ * size.from_eye.z + depth_absolute_;
    if (facts.perspective)
        bounds.plane_offset = numerator_error;
    else
        bounds.depth_absolute += numerator_error * (1 + compounded(volume_factor)) + of_start;
    return bounds;
}

TriangleBounds RayBounds::of(const ViewFacts& facts, const TriangleExtent& extent) const {
    TriangleSize size = extent.size;
    if (precision_.world_absolute > 0)
        size.plane.volume =
            std::max(0.0, size.plane.volume - volume_moved_by(precision_.world_absolute, facts, extent));
    TriangleBounds bounds = on_plane(facts, size);
    (facts.perspective ? bounds.depth_factor : bounds.depth_absolute) +=
        mean_error(facts, extent, size.plane.volume);
    bounds.weight_tolerance = precision_.barycentric_tolerance;
    const double aim = aim_.at_depth_px(size.largest_depth());
    const double corners = corners_px_times_depth(facts, extent) + tolerance_px_times_depth(facts, extent);
    bounds.edge_rounding_px = edges_px(facts, extent);
    const double edges = std::ranges::max(bounds.edge_rounding_px);
    bounds.eps_base_px = aim + edges + (facts.perspective ? 0 : corners);
    bounds.eps_per_inverse_depth = facts.perspective ? corners : 0;
    if (facts.perspective && precision_.test == RayTest::pluecker) {
        // a corner far away moves an edge that passes the eye closely by little: the lesser of two bounds
        const double nearest = std::max(std::ranges::min(extent.size.depth), facts.view.camera.near_depth);
        const bool is_large = precision_.barycentric_tolerance == 0 && corners > edges * nearest;
        const double of_edges = is_large ? pluecker_corners_px(facts, extent, unit_) : unlimited;
        if (of_edges * nearest < corners) {
            bounds.eps_base_px += of_edges;
            bounds.eps_per_inverse_depth = 0;
        }
    }
    if (precision_.hit_point == HitPoint::barycentrics) {
        // a mean of corners has 6 roundings, and 5 more on its way into the camera
        bounds.depth_absolute += gammas_of(unit_)[11] * size.from_origin.z;
    }
    if (precision_.world_absolute > 0) add_world_error(bounds, facts);
    const auto slack = [&](double plane_depth) {
        const double share = compounded(unit_ + bounds.depth_factor + bounds.plane_offset * plane_depth);
        return std::isinf(share) ? share : std::abs(plane_depth) * share + bounds.depth_absolute;
    };
    const Camera& c = facts.view.camera;
    bounds.near_slack = slack(c.near_depth);
    bounds.far_slack = std::isfinite(c.far_depth) ? slack(c.far_depth) : 0;
    // frames hold float32: a wider depth is rounded on its way there, a float32 only by further roundings
    const int roundings = precision_.depth_roundings - (precision_.arithmetic == Arithmetic::float32);
    if (roundings == 1) bounds.depth_factor += unit_roundoff_float32;
    if (roundings > 1) bounds.depth_factor += gamma(roundings, unit_roundoff_float32);
    bounds.may_be_missing = may_be_missed(facts, extent);
    return bounds;
}

std::array<double, 3> RayBounds::edges_px(const ViewFacts& facts, const TriangleExtent& extent) const {
    switch (precision_.test) {
        case RayTest::pluecker:
            return {pluecker_edge_px(facts, extent, 0, unit_), pluecker_edge_px(facts, extent, 1, unit_),
                    pluecker_edge_px(facts, extent, 2, unit_)};
        case RayTest::moeller_trumbore:
            return moeller_trumbore_px(facts, extent, unit_);
        case RayTest::woop:
            return {};  // what rounds lies at the corners
    }
    return {unlimited, unlimited, unlimited};
}

double RayBounds::corners_px_times_depth(const ViewFacts& facts, const TriangleExtent& extent) const {
    const double corner = facts.scale.lateral_px(extent.size.from_eye);
    switch (precision_.test) {
        case RayTest::pluecker:
            // the robust test admits barycentrics down to -2u: a step of at most 2u (|v_i| + |q|)
            return 5 * (unit_ * corner);
        case RayTest::moeller_trumbore:
            return 0;  // differences of corners are counted with the edges
        case RayTest::woop:
            // a corner is sheared with 4 roundings; a product of two sheared corners has 2 more
            return 3 * gammas_of(unit_)[4] * corner;
    }
    return unlimited;
}

/// A weight of minus the tolerance lies that share of the determinant outside its edge.
double RayBounds::tolerance_px_times_depth(const ViewFacts& facts, const TriangleExtent& extent) const {
    if (precision_.barycentric_tolerance == 0) return 0;
    double largest = 0;
    for (std::size_t edge = 0; edge < 3; ++edge)
        largest =
            std::max(largest, facts.distance_px(precision_.barycentric_tolerance * extent.size.plane.volume,
                                                edge_moment(facts, extent, edge)));
    return largest;
}

double RayBounds::mean_error(const ViewFacts& facts, const TriangleExtent& extent, double volume) const {
    const bool is_of_depths = precision_.hit_point == HitPoint::barycentrics;
    if (!is_of_depths && precision_.test != RayTest::woop) return 0;
    const double range = is_of_depths ? range_of_depths(extent) : range_of_distances(extent);
    if (range == 0) return 0;
    // the weights' sum is the volume, in perspectives over the depth
    const double share =
        weights_error(precision_, extent.v_world, facts.origin_abs, facts.direction_abs) / volume;
    const double of_sum = compounded(share * (facts.perspective ? extent.size.largest_depth() : 1));
    return share * range * (1 + 3 * precision_.barycentric_tolerance) * (1 + of_sum);
}

void RayBounds::add_world_error(TriangleBounds& bounds, const ViewFacts& facts) const {
    const Camera& c = facts.view.camera;
    // three weights down to minus the tolerance add up to so much in absolute value
    const double error = precision_.world_absolute * (1 + 6 * precision_.barycentric_tolerance);
    const auto along = [&](const glm::dvec3& axis) { return error * sum_abs(axis); };
    const double lateral = facts.scale.lateral_px({along(c.right), along(c.up), along(c.back)});
    (facts.perspective ? bounds.eps_per_inverse_depth : bounds.eps_base_px) += lateral;
    (facts.perspective ? bounds.depth_eps_per_inverse_depth : bounds.depth_eps_base_px) += lateral;
    bounds.depth_absolute += along(c.back);
}

/// normal . direction, for a direction of unit length, is at least the volume over the greatest depth.
bool RayBounds::may_be_missed(const ViewFacts& facts, const TriangleExtent& extent) const {
    if (precision_.least_determinant == 0) return false;
    const double length = glm::length(facts.direction_abs), rounding = gammas_of(unit_)[8];
    const double depth = facts.perspective ? extent.size.largest_depth() : 1;
    const PlaneSize& plane = extent.size.plane;
    const double terms = rounding * (facts.perspective ? plane.numerator_abs : plane.volume_abs);
    const double least = (plane.volume / depth - terms) / length;
    return !(least >= precision_.least_determinant);
}

}  // namespace zproof
