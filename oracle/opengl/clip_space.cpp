#include "oracle/opengl/clip_space.h"

#include <cmath>

namespace zproof::oracle::opengl {
namespace {

constexpr glm::vec4 never_clipped{0, 0, 0, 1};

/// A function of the corner relative to the eye: along_right x + along_up y + along_depth depth + constant.
glm::vec4 row(const Camera& camera, const glm::dvec3& along, double constant) {
    return glm::vec4(
        glm::dvec4(along.x * camera.right + along.y * camera.up - along.z * camera.back, constant));
}

/// u = (2 x - (right + left) depth) / (right - left) and likewise v; both are divided by w = depth.
ClipRows perspective(const Camera& c) {
    const Window& w = c.window;
    const double width = w.right - w.left, height = w.top - w.bottom;
    const bool ends = std::isfinite(c.far_depth);
    return {.eye_world = c.eye_world,
            .x = row(c, {2 / width, 0, -(w.right + w.left) / width}, 0),
            .y = row(c, {0, 2 / height, -(w.top + w.bottom) / height}, 0),
            .z = row(c, {0, 0, 0}, c.near_depth),
            .w = row(c, {0, 0, 1}, 0),
            .far_distance = ends ? row(c, {0, 0, -1}, c.far_depth) : never_clipped};
}

/// The view ray through p meets the plane of the eye at (x, y) - shear depth.
ClipRows parallel(const Camera& c) {
    const Window& w = c.window;
    const double width = w.right - w.left, height = w.top - w.bottom, range = c.far_depth - c.near_depth;
    return {.eye_world = c.eye_world,
            .x = row(c, {2 / width, 0, -2 / width * c.shear.x}, -(w.right + w.left) / width),
            .y = row(c, {0, 2 / height, -2 / height * c.shear.y}, -(w.top + w.bottom) / height),
            .z = row(c, {0, 0, -1 / range}, c.far_depth / range),
            .w = row(c, {0, 0, 0}, 1),
            .far_distance = never_clipped};
}

}  // namespace

ClipRows clip_rows(const Camera& camera) {
    return camera.projection == Projection::perspective ? perspective(camera) : parallel(camera);
}

DepthFromZ::DepthFromZ(const Camera& camera)
    : perspective_(camera.projection == Projection::perspective),
      near_(static_cast<float>(camera.near_depth)),  // what clip space was given
      far_(camera.far_depth),
      range_(camera.far_depth - camera.near_depth) {}

}  // namespace zproof::oracle::opengl
