#include "compare/adjudicate/image_box.h"

#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

/// Rounding moves a camera-space corner by at most 4u |v|, and its quotient in the image by 16 times that
/// over the least depth.
BoxProjection::BoxProjection(const View& view)
    : camera_(view.camera),
      perspective_(view.camera.projection == Projection::perspective),
      sample_px_(view.sample.offset_px),
      px_per_u_(view.width / (camera_.window.right - camera_.window.left)),
      px_per_v_(view.height / (camera_.window.top - camera_.window.bottom)),
      least_depth_(perspective_ ? camera_.near_depth / 2 : -std::numeric_limits<double>::infinity()),
      px_of_rounding_(64 * unit_roundoff_float64 *
                      (1 + std::abs(camera_.shear.x) + std::abs(camera_.shear.y)) *
                      std::max(px_per_u_, px_per_v_) / (perspective_ ? least_depth_ : 1)) {}

std::optional<Box> BoxProjection::operator()(const CornersWorld& p_world) const {
    std::array<glm::dvec3, 3> p_camera;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 v = glm::dvec3(p_world[i]) - glm::dvec3(camera_.eye_world);
        p_camera[i] = to_camera(v);
        size = std::max(size, size_of(v));
    }
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = p_camera[i], &q = p_camera[(i + 1) % 3];
        if (p.z >= least_depth_) add(box, p);
        if ((p.z >= least_depth_) != (q.z >= least_depth_))
            add(box, p + (least_depth_ - p.z) / (q.z - p.z) * (q - p));
    }
    if (!(box.left <= box.right)) return std::nullopt;
    return widen(box, size);
}

std::optional<Box> BoxProjection::operator()(const glm::vec3& p_world) const {
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(camera_.eye_world);
    const glm::dvec3 p_camera = to_camera(v);
    if (!(p_camera.z >= least_depth_)) return std::nullopt;
    Box box;
    add(box, p_camera);
    return box.is_empty() ? std::nullopt : std::optional(widen(box, size_of(v)));
}

glm::dvec3 BoxProjection::to_camera(const glm::dvec3& v) const {
    return {dot(camera_.right, v), dot(camera_.up, v), -dot(camera_.back, v)};
}

void BoxProjection::add(Box& box, const glm::dvec3& p) const {
    const double u = perspective_ ? p.x / p.z : p.x - camera_.shear.x * p.z;
    const double v = perspective_ ? p.y / p.z : p.y - camera_.shear.y * p.z;
    box.add((u - camera_.window.left) * px_per_u_ - sample_px_.x,
            (camera_.window.top - v) * px_per_v_ - sample_px_.y);
}

/// Scaling and the window's offset add a few ulps of the result.
Box BoxProjection::widen(Box box, double size) const {
    const double reach =
        std::max({std::abs(box.left), std::abs(box.right), std::abs(box.top), std::abs(box.bottom), 65536.0});
    box.widen(px_of_rounding_ * size + 16 * unit_roundoff_float64 * reach);
    return box;
}

}  // namespace zproof
