/// World -> camera -> clip -> NDC -> raster space, in float64, by the stages of the lessons (seeds/):
///
///     camera   p_camera = camera_from_world p_world; the camera looks down -z, camera depth is -z_camera
///     screen   p_screen = (x_camera, y_camera) / -z_camera: the perspective divide, onto the canvas l, r, b,
///     t NDC      x_ndc = 2 x_screen / (r - l) - (r + l) / (r - l); y likewise with b and t raster   x_raster
///     = (x_ndc + 1) / 2 * W, y_raster = (1 - y_ndc) / 2 * H: "in raster space y is down"
///
/// The lessons put the canvas on the near plane, hence their near * x / -z and l = near * window.left; near
/// cancels in NDC, so the canvas stands at depth 1 here and two roundings are saved. Clip space is NDC before
/// the divide: w = -z_camera for perspective, 1 for parallel projections.
#pragma once

#include <glm/glm.hpp>

#include "scenes/camera.h"

namespace zproof::rasterizer {

/// World to camera space: axes in the rows, then the eye at the origin.
glm::dmat4 camera_from_world(const Camera& camera);

/// Camera to clip space. Row 2 maps camera depth near and far to the range that camera.ndc_depth names; far
/// may be +inf for perspective. z_ndc is for people and reports: the renderer clips and compares camera depth
/// itself, since z_ndc of a far point loses far / near of its precision.
glm::dmat4 clip_from_camera(const Camera& camera);

/// A vertex before the perspective divide.
struct ClipVertex {
    double x = 0, y = 0, w = 0;
    double depth = 0;  ///< camera depth, scene units; equals w for perspective
};

/// A row of a matrix.
struct Row {
    double x = 0, y = 0, z = 0, w = 0;

    /// The row applied to (p, q, r, 1), in one fixed order.
    [[gnu::always_inline]] double of(double p, double q, double r) const {
        return ((x * p + y * q) + z * r) + w;
    }
};

/// The fused clip_from_world of a camera, without its z row and with camera depth instead.
class ClipTransform {
  public:
    explicit ClipTransform(const Camera& camera);

    ClipVertex operator()(const glm::vec3& p_world) const noexcept {
        return at(p_world.x, p_world.y, p_world.z);
    }

    /// The clip position from three numbers, for kernels (kernel.h).
    [[gnu::always_inline]] ClipVertex at(double x_world, double y_world, double z_world) const noexcept {
        const double depth = depth_row_.of(x_world, y_world, z_world);
        const double w = projection_ == Projection::perspective ? depth : 1.0;
        return {x_row_.of(x_world, y_world, z_world), y_row_.of(x_world, y_world, z_world), w, depth};
    }

  private:
    Row x_row_, y_row_, depth_row_;
    Projection projection_;
};

}  // namespace zproof::rasterizer
