#include "compare/adjudicate/image_box.h"

#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

/// What a coordinate in camera space errs by, of the vector's size: three products and their sum.
constexpr double error_in_camera = 4 * unit_roundoff_float64;

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The place in camera space where an edge meets the eye's depth, and how far each coordinate may be off.
struct EyeCrossing {
    glm::dvec3 place, error;
};

EyeCrossing crossing_at_eye(const glm::dvec3& before, const glm::dvec3& behind, double error) {
    const glm::dvec3 per_depth = (behind - before) / (before.z - behind.z);
    return {before + before.z * per_depth, error * (1.0 + glm::abs(per_depth))};
}

/// What passes the eye's depth goes to infinity in the image, towards the side of the place where it does.
void extend(Box& box, const EyeCrossing& crossing) {
    const auto& [place, error] = crossing;
    if (!(place.x < -error.x)) box.right = Box::without_end;
    if (!(place.x > error.x)) box.left = -Box::without_end;
    if (!(place.y < -error.y)) box.top = -Box::without_end;
    if (!(place.y > error.y)) box.bottom = Box::without_end;
}

}  // namespace

BoxProjection::BoxProjection(const View& view)
    : camera_(view.camera),
      perspective_(view.camera.projection == Projection::perspective),
      sample_px_(view.sample.offset_px),
      px_per_u_(view.width / (camera_.window.right - camera_.window.left)),
      px_per_v_(view.height / (camera_.window.top - camera_.window.bottom)),
      least_depth_(perspective_ ? camera_.near_depth / 2 : -std::numeric_limits<double>::infinity()) {}

BoxProjection::InCamera BoxProjection::in_camera(const CornersWorld& p_world) const {
    InCamera corners{};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 v = glm::dvec3(p_world[i]) - glm::dvec3(camera_.eye_world);
        corners.p_camera[i] = to_camera(v);
        corners.size = std::max(corners.size, size_of(v));
    }
    return corners;
}

Box BoxProjection::operator()(const CornersWorld& p_world) const {
    const InCamera corners = in_camera(p_world);
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = corners.p_camera[i], &q = corners.p_camera[(i + 1) % 3];
        if (p.z >= least_depth_) add(box, p);
        if ((p.z >= least_depth_) != (q.z >= least_depth_))
            add(box, p + (least_depth_ - p.z) / (q.z - p.z) * (q - p));
    }
    return box.left <= box.right ? widen(box, corners.size, least_depth_) : Box{};
}

Box BoxProjection::before_eye(const CornersWorld& p_world) const {
    if (!perspective_) return (*this)(p_world);
    const auto [p_camera, size] = in_camera(p_world);
    const double error = error_in_camera * size;
    const auto is_before = [&](const glm::dvec3& p) { return p.z > error; };
    Box box;
    double nearest = least_depth_;
    for (const glm::dvec3& p : p_camera) {
        if (!is_before(p)) continue;
        add(box, p);
        nearest = std::min(nearest, p.z);
    }
    if (!(box.left <= box.right)) {
        const bool is_behind = std::ranges::all_of(p_camera, [&](const auto& p) { return p.z < -error; });
        return is_behind ? Box{} : Box::unlimited();
    }
    box = widen(box, size, nearest);
    for (std::size_t i = 0; i < 3; ++i)
        for (const std::size_t other : {(i + 1) % 3, (i + 2) % 3})
            if (is_before(p_camera[i]) && !is_before(p_camera[other]))
                extend(box, crossing_at_eye(p_camera[i], p_camera[other], error));
    return box;
}

Box BoxProjection::operator()(const glm::vec3& p_world) const {
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(camera_.eye_world);
    const glm::dvec3 p_camera = to_camera(v);
    Box box;
    if (p_camera.z >= least_depth_) add(box, p_camera);
    return box.is_empty() ? box : widen(box, size_of(v), least_depth_);
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

/// A quotient in the image errs by 16 times its corner's error over the depth. Scaling and the window's
/// offset add a few ulps of the result.
Box BoxProjection::widen(Box box, double size, double nearest) const {
    const double reach =
        std::max({std::abs(box.left), std::abs(box.right), std::abs(box.top), std::abs(box.bottom), 65536.0});
    const double of_corner = 16 * error_in_camera *
                             (1 + std::abs(camera_.shear.x) + std::abs(camera_.shear.y)) *
                             std::max(px_per_u_, px_per_v_) / (perspective_ ? nearest : 1);
    const double by = of_corner * size + 16 * unit_roundoff_float64 * reach;
    if (!std::isfinite(by)) return Box::unlimited();
    box.widen(by);
    return box;
}

}  // namespace zproof
