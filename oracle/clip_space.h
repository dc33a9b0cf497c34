/// World -> clip space for graphics APIs, and from their z-buffers back to camera depth.
///
/// The eye is subtracted first, so that float32 costs nothing where a scene lies far from the world's origin.
/// Clip space has y up, and w is depth for perspective, 1 for parallel projections. A z-buffer holds [0, 1]:
///     reversed_z   1 at near. perspective: near / depth, as precise far away as a float32 can be; far is a
///                  clip distance of its own. parallel: (far - depth) / (far - near).
///     standard_z   0 at near. perspective: s - near s / depth with s = far / (far - near), or 1 where far is
///                  infinite. parallel: (depth - near) / (far - near).
#pragma once

#include <glm/glm.hpp>

#include "frame/precision.h"
#include "scenes/camera.h"

namespace zproof::oracle {

/// What cuts at near and far.
enum class PlanesBy {
    z,          ///< 0 <= z <= w; far by a clip distance where z does not end there
    distances,  ///< clip distances of both, for a pipeline that clamps z
};

/// z is reversed_z or standard_z, from 0 to w, or from -w to w before the viewport halves it.
struct ClipSpace {
    DepthBuffer z = DepthBuffer::reversed_z;
    ClipRange range = ClipRange::zero_to_one;
    PlanesBy planes = PlanesBy::z;
};

/// clip = rows times (corner - eye, 1). Made in double, each entry rounded once.
struct ClipRows {
    glm::vec3 eye_world;
    glm::vec4 x, y, z, w;
    glm::vec4 near_distance, far_distance;  ///< >= 0 within the planes; 1 everywhere where nothing is cut
};

ClipRows clip_rows(const Camera& camera, const ClipSpace& space = {});

/// The camera depth of a z-buffer's value. Worked out in double, rounded once; NaN for NaN, +inf for what
/// only an infinite far plane has.
class DepthFromZ {
  public:
    explicit DepthFromZ(const Camera& camera, DepthBuffer z = DepthBuffer::reversed_z);
    float operator()(double z) const {
        const double affine = offset_ + scale_ * z;  // 1 / depth times near, or depth itself
        return static_cast<float>(perspective_ ? near_ / affine : affine);
    }

  private:
    bool perspective_;
    double near_, offset_, scale_;
};

}  // namespace zproof::oracle
