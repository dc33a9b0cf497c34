#include "filters/selftest/filter_fixture.h"

#include <cmath>
#include <numbers>
#include <random>

#include "filters/reference/admissible_surfaces.h"

namespace zproof::selftest {

namespace {

/// Texels of a fixed seed; mt19937 gives the same numbers everywhere.
Image noise(int width, int height) {
    Image image{.name = "noise", .width = width, .height = height, .texels = {}};
    std::mt19937 random{1234};
    for (int i = 0; i < width * height; ++i) {
        for (int channel = 0; channel < 3; ++channel) image.texels.push_back(std::uint8_t(random() >> 24));
        image.texels.push_back(255);
    }
    return image;
}

/// A quad on y = 0 that reaches beyond both sides of the picture and far towards its horizon.
Vertices ground_vertices() {
    constexpr float side = 40, near = 0.25f, far = 60, texels_per_unit = 20;
    Vertices v;
    const std::array<glm::vec2, 4> corners{{{-side, near}, {side, near}, {side, far}, {-side, far}}};
    Bulk<glm::vec2> uv;
    for (const glm::vec2& p : corners) {
        v.position_world.push_back({p.x, 0, -p.y});
        uv.push_back(glm::vec2{0.0263f, 0.0134f} + p * (texels_per_unit / 128));
    }
    v.uv = {uv};
    return v;
}

Scene scene_of(Ground ground) {
    Scene scene;
    scene.name = "filter-ground";
    scene.vertices = ground_vertices();
    scene.triangles = {{0, 1, 2}, {0, 2, 3}};
    Texture texture{.image = 0, .sampler = {}, .uv_set = 0, .transform = {}};
    if (ground == Ground::mirrored)
        texture.sampler = {.wrap_u = Wrap::mirrored_repeat, .wrap_v = Wrap::clamp_to_edge};
    if (ground == Ground::mirrored) texture.transform.linear = glm::dmat2{0.25, 0, 0, 0.25};
    if (ground == Ground::turned) {
        const double angle = std::numbers::pi / 6, c = std::cos(angle), s = std::sin(angle);
        texture.transform = {.linear = glm::dmat2{c, s, -s, c}, .translation = {0.137, 0.071}};
    }
    scene.materials = {
        {.name = "ground", .base_color_factor = {0.9f, 0.8f, 1.0f, 1.0f}, .base_color = texture}};
    scene.parts = {{.node = "ground",
                    .mesh = "ground",
                    .primitive = 0,
                    .first_triangle = 0,
                    .triangle_count = 2,
                    .material = 0}};
    scene.images = {ground == Ground::odd_sizes ? noise(107, 61) : noise(128, 128)};
    return scene;
}

View ground_view() {
    View view{.name = "to-the-horizon", .camera = {}, .width = 120, .height = 96};
    const double pitch = 20 * std::numbers::pi / 180;
    view.camera = look_at({0, 1, 0}, {0, 1 - std::sin(pitch), -std::cos(pitch)}, {0, 1, 0});
    view.camera.window = symmetric_window(std::numbers::pi / 3, double(view.width) / view.height);
    view.camera.near_depth = 0.05;
    return view;
}

}  // namespace

FilterFixture filter_fixture(Ground ground) {
    FilterFixture fixture{scene_of(ground), ground_view(), {}};
    fixture.frame = oracle::exact_visibility(fixture.scene, fixture.view);
    return fixture;
}

}  // namespace zproof::selftest
