#include "bench/scenes.h"

#include <cmath>
#include <random>

namespace zproof::bench {
namespace {

/// A sheet of 2 x columns x rows triangles; place(u, v) for u, v in [0, 1].
template <class Position>
void add_sheet(Scene& scene, int columns, int rows, Position place) {
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    const auto stride = std::uint32_t(columns + 1);
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double u = double(i) / columns, v = double(j) / rows;
            scene.vertices.position_world.push_back(glm::vec3(place(u, v)));
        }
    }
    for (std::uint32_t j = 0; j < std::uint32_t(rows); ++j) {
        for (std::uint32_t i = 0; i < std::uint32_t(columns); ++i) {
            const std::uint32_t a = first + j * stride + i;
            scene.triangles.push_back({a, a + 1, a + stride});
            scene.triangles.push_back({a + 1, a + stride + 1, a + stride});
        }
    }
}

Scene room_scene() {
    Scene scene;
    const double size = 4;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        add_sheet(scene, 10, 10, [&](double u, double v) {
            glm::dvec3 p;
            p[axis] = side % 2 ? size : -size;
            p[(axis + 1) % 3] = size * (2 * u - 1);
            p[(axis + 2) % 3] = size * (2 * v - 1);
            return p;
        });
    }
    const double pi = std::acos(-1.0);
    for (int ball = 0; ball < 12; ++ball) {
        const glm::dvec3 centre{std::sin(ball * 1.7) * 2.5, std::cos(ball * 2.3) * 2.0,
                                -1.5 + std::sin(ball * 0.9) * 1.5};
        add_sheet(scene, 30, 15, [&](double u, double v) {
            const double a = 2 * pi * u, b = pi * v;
            return centre +
                   0.6 * glm::dvec3{std::cos(a) * std::sin(b), std::cos(b), std::sin(a) * std::sin(b)};
        });
    }
    return scene;
}

Scene ripples_scene(int columns, int rows) {
    Scene scene;
    add_sheet(scene, columns, rows, [](double u, double v) {
        return glm::dvec3{8 * (u - 0.5), 4.5 * (v - 0.5), -3.6 + 0.05 * std::sin(40 * u) * std::cos(30 * v)};
    });
    return scene;
}

Scene soup_scene() {
    Scene scene;
    std::mt19937 random(1);
    const auto within = [&](double low, double high) {
        return low + (high - low) * double(random()) / 0x1p32;
    };
    for (std::uint32_t i = 0; i < 200'000; ++i) {
        const double depth = within(1, 10), size = 0.032 * depth;
        const glm::dvec3 middle{within(-1.1, 1.1) * depth, within(-0.61875, 0.61875) * depth, -depth};
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 aside{within(-1, 1), within(-1, 1), within(-1, 1)};
            scene.vertices.position_world.push_back(glm::vec3(middle + size * aside));
        }
        scene.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return scene;
}

View view_from(float eye_z) {
    View view{.name = "timed", .camera = {}, .width = 1920, .height = 1080};
    view.camera.eye_world = {0, 0, eye_z};
    view.camera.window = {.left = -1.1, .right = 1.1, .bottom = -0.61875, .top = 0.61875};
    return view;
}

}  // namespace

TimedScene room() { return {"room", room_scene(), view_from(3)}; }

TimedScene ripples(int columns, int rows) { return {"ripples", ripples_scene(columns, rows), view_from(0)}; }

TimedScene soup() { return {"soup", soup_scene(), view_from(0)}; }

}  // namespace zproof::bench
