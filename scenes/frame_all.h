/// A camera for scenes that bring none.
#pragma once

#include "scenes/camera.h"
#include "scenes/scene.h"

namespace zproof {

/// A perspective camera (vertical field of view 45 degrees) in front of, above and to the right of the bounds
/// of all triangles, looking at their centre; the bounds fill the window, and near and far enclose them.
/// Aspect is width / height. A scene without triangles gets a camera at (0, 0, 1) that looks at the origin.
/// Throws SceneError where float32 cannot hold such an eye: bounds too large, or too small for their distance
/// from 0.
Camera frame_all(const Scene& scene, double aspect);

}  // namespace zproof
