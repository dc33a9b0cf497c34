#include "scenes/filters/scenes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::filters {

namespace {

constexpr int walls = 16;
constexpr double far_end = -512;

/// A wall of the tube round the z axis, the texture four times round it and once in 4 units along it.
void add_wall(TexturedMesh& mesh, int wall) {
    const auto corner = [&](int side, double z) {
        const glm::dvec2 p = suite::unit_circle(double(wall + side) / walls);
        return Corner{{p.x, p.y, z}, {float(wall + side) / 4, float(-z / 4)}};
    };
    mesh.quad({corner(0, 2), corner(1, 2), corner(1, far_end), corner(0, far_end)});
}

}  // namespace

Loaded tunnel(ImageSize size) {
    TexturedMesh mesh("tunnel");
    mesh.begin_part("tunnel", image_texture(0));
    for (int wall = 0; wall < walls; ++wall) add_wall(mesh, wall);
    const suite::Intrinsics intrinsics{.half_height = 0.75, .near_depth = 0.125, .far_depth = 1024};
    return mesh.finish(
        {coloured_octaves()},
        {suite::perspective_view("along", size, {.eye_world = {0.1, 0.2, 0}, .target_world = {0.1, 0.2, -1}},
                                 intrinsics),
         suite::perspective_view("aside", size, {.eye_world = {-0.3, 0.1, 0}, .target_world = {0.2, 0, -1}},
                                 intrinsics)});
}

}  // namespace zproof::filters
