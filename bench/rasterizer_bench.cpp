// Times the rasterizer at 1920 x 1080 on the process's own number of threads; prints the best and the median
// of 21 runs per scene. A figure for people: nothing depends on it.
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "rasterizer/rasterizer.h"

namespace {

using namespace zproof;

/// A sheet of 2 x columns x rows triangles; place(u, v) for u, v in [0, 1].
template <class Place>
void add_sheet(Scene& scene, int columns, int rows, Place place) {
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

/// A room seen from inside, with balls in it: 12 k triangles, walls around and behind the eye.
Scene room() {
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

/// A rippled sheet that fills the view: a million triangles of two pixels each.
Scene ripples() {
    Scene scene;
    add_sheet(scene, 1000, 500, [](double u, double v) {
        return glm::dvec3{8 * (u - 0.5), 4.5 * (v - 0.5), -3.6 + 0.05 * std::sin(40 * u) * std::cos(30 * v)};
    });
    return scene;
}

void time_scene(const char* name, const Scene& scene) {
    View view;
    view.camera.eye_world = {0, 0, 0};
    view.camera.window = {.left = -1.1, .right = 1.1, .bottom = -0.61875, .top = 0.61875};
    if (scene.triangles.size() < 100'000) view.camera.eye_world = {0, 0, 3};
    std::vector<double> milliseconds;
    std::size_t covered = 0;
    for (int run = 0; run < 21; ++run) {
        const auto start = std::chrono::steady_clock::now();
        const Frame frame = rasterizer::render(scene, view);
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
        milliseconds.push_back(elapsed.count());
        covered = frame.size().pixel_count() -
                  std::size_t(std::ranges::count(frame.primitive.pixels(), PrimitiveId::none));
    }
    std::ranges::sort(milliseconds);
    std::printf("%-10s %8zu triangles %8zu pixels covered: best %7.2f ms, median %7.2f ms\n", name,
                scene.triangles.size(), covered, milliseconds.front(), milliseconds[milliseconds.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : tbb::task_arena::automatic;
    tbb::task_arena arena(threads);
    const std::string_view only = argc > 2 ? argv[2] : "";
    arena.execute([&] {
        if (only != "ripples") time_scene("room", room());
        if (only != "room") time_scene("ripples", ripples());
    });
}
