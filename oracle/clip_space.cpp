#include "oracle/clip_space.h"

#include <cmath>

namespace zproof::oracle {
namespace {

constexpr glm::vec4 never_clipped{0, 0, 0, 1};

/// A function of the corner relative to the eye: along_right x + along_up y + along_depth depth + constant.
struct Row {
    glm::dvec3 along;
    double constant;

    glm::vec4 rounded(const Camera& camera) const {
        return glm::vec4(
            glm::dvec4(along.x * camera.right + along.y * camera.up - along.z * camera.back, constant));
    }
};

/// z before the divide, from 0 to w.
Row z_row(const Camera& c, DepthBuffer z) {
    const bool standard = z == DepthBuffer::standard_z;
    const double range = c.far_depth - c.near_depth;
    if (c.projection == Projection::parallel)
        return standard ? Row{{0, 0, 1 / range}, -c.near_depth / range}
                        : Row{{0, 0, -1 / range}, c.far_depth / range};
    if (!standard) return {{0, 0, 0}, c.near_depth};
    const double share = std::isfinite(c.far_depth) ? c.far_depth / range : 1;
    return {{0, 0, share}, -c.near_depth * share};
}

Row doubled_less(const Row& z, const Row& w) {
    return {2.0 * z.along - w.along, 2 * z.constant - w.constant};
}

/// u = (2 x - (right + left) depth) / (right - left) and likewise v; both are divided by w = depth. Parallel:
/// the view ray through p meets the plane of the eye at (x, y) - shear depth.
Row side_row(const Camera& c, const glm::dvec3& axis, double low, double high, double shear) {
    const double extent = high - low, middle = -(high + low) / extent;
    if (c.projection == Projection::perspective) return {2 / extent * axis + glm::dvec3(0, 0, middle), 0};
    return {2 / extent * axis + glm::dvec3(0, 0, -2 / extent * shear), middle};
}

}  // namespace

ClipRows clip_rows(const Camera& c, const ClipSpace& space) {
    const Window& window = c.window;
    const bool perspective = c.projection == Projection::perspective, ends = std::isfinite(c.far_depth);
    const bool z_ends = !perspective || (space.z == DepthBuffer::standard_z && ends);
    const bool by_distances = space.planes == PlanesBy::distances;
    const Row w = perspective ? Row{{0, 0, 1}, 0} : Row{{0, 0, 0}, 1};
    const Row z = z_row(c, space.z);
    const Row near{{0, 0, 1}, -c.near_depth}, far{{0, 0, -1}, c.far_depth};
    return {.eye_world = c.eye_world,
            .x = side_row(c, {1, 0, 0}, window.left, window.right, c.shear.x).rounded(c),
            .y = side_row(c, {0, 1, 0}, window.bottom, window.top, c.shear.y).rounded(c),
            .z = (space.range == ClipRange::zero_to_one ? z : doubled_less(z, w)).rounded(c),
            .w = w.rounded(c),
            .near_distance = by_distances ? near.rounded(c) : never_clipped,
            .far_distance = ends && (by_distances || !z_ends) ? far.rounded(c) : never_clipped};
}

DepthFromZ::DepthFromZ(const Camera& c, DepthBuffer z)
    : perspective_(c.projection == Projection::perspective), near_(0) {
    const bool standard = z == DepthBuffer::standard_z;
    const double range = c.far_depth - c.near_depth;
    if (!perspective_) {
        offset_ = standard ? c.near_depth : c.far_depth;
        scale_ = standard ? range : -range;
        return;
    }
    const double share = standard && std::isfinite(c.far_depth) ? c.far_depth / range : 1;
    near_ = standard ? c.near_depth * share : static_cast<float>(c.near_depth);  // what clip space was given
    offset_ = standard ? share : 0;
    scale_ = standard ? -1 : 1;
}

}  // namespace zproof::oracle
