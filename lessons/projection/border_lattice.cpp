#include "lessons/projection/border_lattice.h"

namespace zproof::study::projection {

View lattice_view() {
    View view{.name = "lesson", .camera = {}};
    view.camera.near_depth = 0.1;
    view.width = 640, view.height = 480;
    return view;
}

Scene border_lattice() {
    constexpr int across = 64, down = 16, depths = 7;
    Scene scene;
    scene.name = "pixel borders";
    for (int j = 1 - down; j < down; ++j)
        for (int i = 1 - across; i < across; ++i) {
            // i / 64 and j / 16 times a small whole number: exact in float32; 320 i / 64 is 5 i, 240 j / 16
            // is 15 j.
            const float depth = float(1 + (i + j + across + down) % depths);
            scene.vertices.position_world.emplace_back(float(i) / across * depth, float(j) / down * depth,
                                                       -depth);
        }
    return scene;
}

}  // namespace zproof::study::projection
