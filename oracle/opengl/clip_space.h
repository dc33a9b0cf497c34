/// World -> clip space for OpenGL, and from its z-buffer back to camera depth.
///
/// The eye is subtracted first, so that float32 costs nothing where a scene lies far from the world's origin.
/// Clip space has y up and z in [0, 1] after the divide, reversed: the near plane is at 1.
///     perspective:  w = depth, z = near, so z / w = near / depth, as precise far away as a float32 can be.
///                   z <= w clips at near; far is a clip distance of its own.
///     parallel:     w = 1, z = (far - depth) / (far - near); 0 <= z <= w clips at both.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scenes/camera.h"

namespace zproof::oracle::opengl {

/// clip = rows times (corner - eye, 1). Made in double, each entry rounded once.
struct ClipRows {
    glm::vec3 eye_world;
    glm::vec4 x, y, z, w;
    glm::vec4 far_distance;  ///< >= 0 on this side of the far plane; 1 everywhere where z clips at far
};

ClipRows clip_rows(const Camera& camera);

/// The camera depth of a z-buffer's value. Worked out in double, rounded once; NaN for NaN, +inf for 0 of a
/// perspective.
class DepthFromZ {
  public:
    explicit DepthFromZ(const Camera& camera);
    float operator()(float z) const {
        return static_cast<float>(perspective_ ? near_ / double{z} : far_ - double{z} * range_);
    }

  private:
    bool perspective_;
    double near_, far_, range_;
};

}  // namespace zproof::oracle::opengl
