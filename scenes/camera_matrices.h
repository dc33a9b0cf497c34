/// A camera as the matrices that follow from it, in double, for renderers that take matrices.
#pragma once

#include <array>

#include "scenes/camera.h"

namespace zproof {

/// By rows, for column vectors.
using MatrixRows = std::array<std::array<double, 4>, 4>;

/// p_camera = camera_from_world p_world.
MatrixRows camera_from_world(const Camera& camera);

/// p_clip = clip_from_camera p_camera; near and far become the ends of the range of the camera's ndc_depth.
MatrixRows clip_from_camera(const Camera& camera);

}  // namespace zproof
