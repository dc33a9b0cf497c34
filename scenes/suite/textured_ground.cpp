#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

/// A checker of 8 x 8 fields whose light fields differ in hue, so that a wrong texel can be told by its
/// colour.
Image checker() {
    Image image{.name = "checker", .width = 256, .height = 256, .texels = {}};
    image.texels.reserve(std::size_t{4} * 256 * 256);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool dark = (x / 32 + y / 32) % 2 != 0;
            image.texels.push_back(static_cast<std::uint8_t>(dark ? 24 : 255 - x / 4));
            image.texels.push_back(static_cast<std::uint8_t>(dark ? 24 : 191 + y / 4));
            image.texels.push_back(static_cast<std::uint8_t>(dark ? 32 : 224));
            image.texels.push_back(255);
        }
    return image;
}

/// One texture repeat to 4 scene units of the ground.
void wrap_ground(Scene& scene) {
    Bulk<glm::vec2> uv;
    uv.reserve(scene.vertices.position_world.size());
    for (const glm::vec3& p_world : scene.vertices.position_world)
        uv.emplace_back(p_world.x / 4, p_world.z / 4);
    scene.vertices.uv.push_back(std::move(uv));
    scene.images.push_back(checker());
    scene.materials.front().base_color.image = 0;
}

}  // namespace

Loaded textured_ground(ImageSize size) {
    MeshBuilder mesh("textured_ground");
    Random random(19);
    mesh.begin_part("ground", {1, 1, 1});
    add_sheet(mesh, {.across = 96, .down = 96}, [](double s, double t) {
        return glm::dvec3{8192 * s - 4096, 0, 8192 * t - 8128};
    });
    mesh.begin_part("milestones", {0.8, 0.3, 0.2});
    for (int i = 0; i < 12; ++i) {
        const double depth = 8.0 * (1 << (i / 2)), x = (i % 2 == 0 ? -0.45 : 0.3) * depth;
        add_box_between(mesh, {x, 0, -depth - 2}, {x + 0.8, random.uniform(1, 3), -depth});
    }
    const Intrinsics intrinsics{.half_height = 0.5, .near_depth = 0.25, .far_depth = 10'000};
    Loaded loaded = mesh.finish(
        {perspective_view("level", size, {.eye_world = {0, 1.75, 0}, .target_world = {1, 1.5, -10}},
                          intrinsics),
         perspective_view("banked", size,
                          {.eye_world = {3, 12, 8}, .target_world = {-2, 6, -20}, .up_world = {0.4, 1, 0}},
                          intrinsics)});
    wrap_ground(loaded.scene);
    return loaded;
}

}  // namespace zproof::suite
