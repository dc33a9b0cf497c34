/// What the depth buffer holds, and the way from there to camera depth.
#pragma once

#include "tests/mutants/plain/mesh.h"

namespace plain {

enum class DepthBuffer {
    camera_depth,  ///< 1 / depth, or minus depth in parallel views; float32
    reversed_z,    ///< 1 at near; far is infinite in perspective views; float32
    standard_z24,  ///< 0 at near, 1 at far; 24 bits, fixed point
};

/// z of a camera depth D: factor + offset / D in perspective views, factor D + offset in parallel ones.
struct ZMapping {
    double factor, offset;
};

ZMapping z_mapping(const Camera& camera, DepthBuffer buffer);

/// Turns z into what is stored, and that into camera depth. The greater stored number is the nearer one.
class DepthCode {
  public:
    DepthCode(const Camera& camera, DepthBuffer buffer);

    float stored(float z) const;
    float camera_depth(float stored) const;

  private:
    Projection projection_;
    DepthBuffer buffer_;
    ZMapping z_;
    float largest_;  ///< step that may be stored: that of far, which an infinite far does not have
};

}  // namespace plain
