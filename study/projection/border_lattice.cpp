#include "study/projection/border_lattice.h"

namespace zproof::study::projection {

namespace {

constexpr int half_width = 256, step = 5, depths = 7;

}  // namespace

View lattice_view() {
    View view{.name = "lesson", .camera = {}};
    view.camera.near_depth = 0.1;
    view.width = view.height = 2 * half_width;
    return view;
}

Scene border_lattice() {
    Scene scene;
    scene.name = "pixel borders";
    for (int j = -half_width + 1; j < half_width; j += step)
        for (int i = -half_width + 1; i < half_width; i += step) {
            // i / 256 times a small whole number: exact in float32.
            const float depth = float(1 + (i + j + 2 * half_width) % depths);
            scene.vertices.position_world.emplace_back(float(i) / half_width * depth,
                                                       float(j) / half_width * depth, -depth);
        }
    return scene;
}

}  // namespace zproof::study::projection
