#include "oracle/primary_ray.h"

#include <algorithm>
#include <limits>

namespace zproof::oracle {
namespace {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<float>::is_iec559,
              "a double beyond float's range rounds to infinity");

/// The point where the view ray meets the camera's window.
glm::dvec2 on_window(const View& view, const glm::dvec2& p_raster) {
    const Window& w = view.camera.window;
    return {w.left + (w.right - w.left) * (p_raster.x / view.width),
            w.top - (w.top - w.bottom) * (p_raster.y / view.height)};
}

PrimaryRay perspective_ray(const Camera& camera, const glm::dvec2& at) {
    const glm::dvec3 direction = at.x * camera.right + at.y * camera.up - camera.back;
    return {.origin = camera.eye_world,
            .direction = glm::vec3(direction),
            .t_near = static_cast<float>(camera.near_depth),
            .t_far = static_cast<float>(camera.far_depth),
            .origin_depth = 0};
}

/// Embree asks for t >= 0. A parallel camera may see behind its eye: then its rays start on the near plane.
PrimaryRay parallel_ray(const Camera& camera, const glm::dvec2& at) {
    const glm::dvec3 direction = camera.shear.x * camera.right + camera.shear.y * camera.up - camera.back;
    const double origin_depth = std::min(camera.near_depth, 0.0);
    const glm::dvec3 origin =
        glm::dvec3(camera.eye_world) + at.x * camera.right + at.y * camera.up + origin_depth * direction;
    return {.origin = glm::vec3(origin),
            .direction = glm::vec3(direction),
            .t_near = static_cast<float>(camera.near_depth - origin_depth),
            .t_far = static_cast<float>(camera.far_depth - origin_depth),
            .origin_depth = origin_depth};
}

}  // namespace

PrimaryRay ray_through(const View& view, const glm::dvec2& p_raster) {
    const glm::dvec2 at = on_window(view, p_raster);
    return view.camera.projection == Projection::perspective ? perspective_ray(view.camera, at)
                                                             : parallel_ray(view.camera, at);
}

PrimaryRay primary_ray(const View& view, int x, int y) { return ray_through(view, sampled_at(view, x, y)); }

}  // namespace zproof::oracle
