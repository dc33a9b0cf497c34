/// Cameras of the suite, written as facts: tangents and lengths, no angles, so that their bits do not depend
/// on a mathematics library.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scenes/view.h"

namespace zproof::suite {

struct ImageSize {
    int width = 1920, height = 1080;  ///< pixels, both >= 1
    double aspect() const { return static_cast<double>(width) / height; }
};

struct CameraPose {
    glm::dvec3 eye_world{0.0}, target_world{0, 0, -1}, up_world{0, 1, 0};
};

struct Intrinsics {
    double half_height = 0.5;  ///< of the window: a tangent for perspective, scene units for parallel views
    double near_depth = 0.1, far_depth = 1000;
};

View perspective_view(const std::string& name, ImageSize size, const CameraPose& pose,
                      const Intrinsics& intrinsics);
View parallel_view(const std::string& name, ImageSize size, const CameraPose& pose,
                   const Intrinsics& intrinsics);

/// The window that is 2 half_height high, as wide as the image asks for, and centred on the axis.
Window centred_window(ImageSize size, double half_height);

}  // namespace zproof::suite
