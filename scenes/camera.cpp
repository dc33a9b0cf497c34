#include "scenes/camera.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "scenes/scene_error.h"

namespace zproof {
namespace {

[[noreturn]] void refuse_field(const char* field, const char* expected) {
    throw SceneError(std::string("camera ") + field + ": expected " + expected);
}

template <typename T>
bool is_finite(const glm::vec<3, T>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_axes(const Camera& camera) {
    constexpr double orthonormal_within = 1e-12;
    const std::array<const glm::dvec3*, 3> axes{&camera.right, &camera.up, &camera.back};
    constexpr std::array names{"right", "up", "back"};
    for (std::size_t i = 0; i < 3; ++i)
        if (!is_finite(*axes[i])) refuse_field(names[i], "finite numbers");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(std::abs(glm::dot(*axes[i], *axes[i]) - 1) <= orthonormal_within))
            refuse_field(names[i], "a vector of length 1 within 1e-12");
        if (!(std::abs(glm::dot(*axes[i], *axes[(i + 1) % 3])) <= orthonormal_within))
            refuse_field(names[i], "right, up and back at right angles within 1e-12");
    }
    if (glm::dot(glm::cross(camera.right, camera.up), camera.back) < 0)
        refuse_field("back", "right-handed axes: back = right x up");
}

void check_window(const Window& window) {
    for (const double side : {window.left, window.right, window.bottom, window.top})
        if (!std::isfinite(side)) refuse_field("window", "finite numbers");
    if (!(window.left < window.right)) refuse_field("window", "left < right");
    if (!(window.bottom < window.top)) refuse_field("window", "bottom < top");
}

void check_depths(const Camera& camera) {
    if (!std::isfinite(camera.near_depth)) refuse_field("near", "a finite number");
    if (camera.projection == Projection::perspective && !(camera.near_depth > 0))
        refuse_field("near", "above 0");
    if (!(camera.near_depth < camera.far_depth)) refuse_field("far", "above near");
    if (camera.projection == Projection::parallel && !std::isfinite(camera.far_depth))
        refuse_field("far", "a finite number for a parallel projection");
}

}  // namespace

void validate(const Camera& camera) {
    if (!is_finite(camera.eye_world)) refuse_field("eye", "finite numbers (float32)");
    check_axes(camera);
    check_window(camera.window);
    if (!std::isfinite(camera.shear.x) || !std::isfinite(camera.shear.y))
        refuse_field("shear", "finite numbers");
    if (camera.projection == Projection::perspective && camera.shear != glm::dvec2(0))
        refuse_field("shear", "0 for a perspective projection");
    check_depths(camera);
}

Camera look_at(const glm::dvec3& eye_world, const glm::dvec3& target_world, const glm::dvec3& up_world) {
    Camera camera;
    camera.eye_world = glm::vec3(eye_world);
    const glm::dvec3 away = glm::dvec3(camera.eye_world) - target_world;
    if (!is_finite(camera.eye_world) || !is_finite(target_world) || !is_finite(up_world))
        refuse_field("look-at", "finite numbers (eye: float32)");
    if (!(glm::length(away) > 0))
        refuse_field("target", "a point other than the eye (after rounding to float32)");
    camera.back = glm::normalize(away);
    // Twice: where up is almost along the view, the first difference has lost most of its digits.
    glm::dvec3 right = glm::cross(up_world, camera.back);
    if (!(glm::length(right) > 1e-9 * glm::length(up_world)))
        refuse_field("up", "a direction not along the view");
    right = glm::normalize(right);
    camera.right = glm::normalize(right - glm::dot(right, camera.back) * camera.back);
    camera.up = glm::normalize(glm::cross(camera.back, camera.right));
    return camera;
}

Window symmetric_window(double yfov_radians, double aspect) {
    const double top = std::tan(yfov_radians / 2);
    return {-top * aspect, top * aspect, -top, top};
}

}  // namespace zproof
