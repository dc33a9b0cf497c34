/// One picture to be made of a scene.
#pragma once

#include <string>

#include "scenes/camera.h"

namespace zproof {

struct View {
    std::string name;  ///< unique within its scene; letters, digits, '-', '_', '.'
    Camera camera;
    int width = 1920, height = 1080;  ///< pixels
};

}  // namespace zproof
