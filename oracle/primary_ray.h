/// The oracle's own way from a pixel to a ray, derived from the camera's facts alone (scenes/camera.h).
#pragma once

#include <glm/glm.hpp>

#include "scenes/view.h"

namespace zproof::oracle {

/// p_world(t) = origin + t direction, for t in [t_near, t_far]. The direction advances one unit of camera
/// depth per unit of t, so that camera depth is origin_depth + t.
///
/// Every float here is a number computed in double and rounded once, to nearest; near and far too, so that a
/// surface within a relative 2^-24 of a clip plane may fall on its other side.
struct PrimaryRay {
    glm::vec3 origin, direction;
    float t_near, t_far;  ///< 0 <= t_near < t_far <= +inf
    double origin_depth;  ///< 0, unless the near plane lies behind the eye: then its (negative) depth
};

/// The view ray through a raster position, within the image or not.
PrimaryRay ray_through(const View& view, const glm::dvec2& p_raster);

/// The view ray through the place where a pixel is sampled (sampled_at()). Pixels outside the image are
/// allowed.
PrimaryRay primary_ray(const View& view, int x, int y);

}  // namespace zproof::oracle
