/// One picture to be made of a scene.
#pragma once

#include <string>

#include "scenes/camera.h"
#include "scenes/sample.h"

namespace zproof {

struct View {
    std::string name;  ///< unique within its scene; letters, digits, '-', '_', '.'
    Camera camera;
    int width = 1920, height = 1080;  ///< pixels
    Sample sample{};                  ///< the same place in every pixel
};

/// The raster position at which pixel (x, y) is sampled; exact.
inline glm::dvec2 sampled_at(const View& view, int x, int y) {
    return glm::dvec2(x + 0.5, y + 0.5) + view.sample.offset_px;
}

}  // namespace zproof
