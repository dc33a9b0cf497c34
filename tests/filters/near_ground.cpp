#include "tests/filters/near_ground.h"

#include <array>
#include <cmath>
#include <numbers>

#include "rasterizer/rasterizer.h"

namespace zproof {

using selftest::FilterFixture;

FilterFixture near_ground() {
    FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    Vertices& v = fixture.scene.vertices;
    constexpr float half_width = 2, far = 8, texels_per_unit = 60;
    const std::array<glm::vec2, 4> corners{
        {{-half_width, 0}, {half_width, 0}, {half_width, far}, {-half_width, far}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        v.position_world[i] = {corners[i].x, 0, -corners[i].y};
        v.uv[0][i] = glm::vec2{0.0263f, 0.0134f} + corners[i] * (texels_per_unit / 128);
    }
    fixture.view.width = 256, fixture.view.height = 256;
    const double pitch = 17 * std::numbers::pi / 180;
    fixture.view.camera = look_at({0, 1, 0}, {0, 1 - std::sin(pitch), -std::cos(pitch)}, {0, 1, 0});
    fixture.view.camera.window = symmetric_window(std::numbers::pi / 6, 1);
    fixture.view.camera.near_depth = 0.05;
    fixture.frame = rasterizer::render(fixture.scene, fixture.view);
    return fixture;
}

FilterFixture head_on_wall(double texels_per_pixel) {
    constexpr int side = 192, texels = 128;
    FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    Vertices& v = fixture.scene.vertices;
    const auto period = float(side * texels_per_pixel / texels);
    const std::array<glm::vec2, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        v.position_world[i] = {corners[i].x, corners[i].y, 0};
        v.uv[0][i] = (corners[i] + 1.0f) * (period / 2);
    }
    fixture.view.width = fixture.view.height = side;
    fixture.view.camera = look_at({0, 0, 1}, {0, 0, 0}, {0, 1, 0});
    fixture.view.camera.window = symmetric_window(std::numbers::pi / 2, 1);
    fixture.view.camera.near_depth = 0.05;
    fixture.frame = rasterizer::render(fixture.scene, fixture.view);
    return fixture;
}

}  // namespace zproof
