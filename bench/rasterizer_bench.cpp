// Times the rasterizer at 1920 x 1080 on the process's own number of threads, frame after frame, and OpenGL
// in turn with it where a driver is there: medians of 21 frames each, their spread and their ratio per scene.
// OpenGL's frame is read back, as ours is in memory. Figures for people: nothing depends on them.
//
//     rasterizer_bench [THREADS [SCENE]]     SCENE: room, ripples or soup; not drawn by OpenGL when named
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include "oracle/opengl.h"
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

/// Triangles everywhere, some 210 pixels each: more than 20 lie behind each other at a pixel.
Scene soup() {
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

View view_of(const Scene& scene) {
    View view;
    view.camera.eye_world = {0, 0, scene.triangles.size() < 100'000 ? 3.0f : 0.0f};
    view.camera.window = {.left = -1.1, .right = 1.1, .bottom = -0.61875, .top = 0.61875};
    return view;
}

template <class Work>
double milliseconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double print(const char* who, std::vector<double> milliseconds) {
    std::ranges::sort(milliseconds);
    const std::size_t n = milliseconds.size();
    std::printf("  %-8s median %7.2f ms (best %.2f, middle half %.2f to %.2f)\n", who, milliseconds[n / 2],
                milliseconds[0], milliseconds[n / 4], milliseconds[3 * n / 4]);
    return milliseconds[n / 2];
}

enum class Beside { nothing, opengl };

void time_scene(const char* name, const Scene& scene, Beside beside) {
    const View view = view_of(scene);
    rasterizer::Renderer renderer;
    std::optional<oracle::OpenGl> opengl;
    if (beside == Beside::opengl && !oracle::opengl_is_missing()) opengl.emplace(scene);
    std::vector<double> ours, theirs;
    for (int run = 0; run < 22; ++run) {
        ours.push_back(milliseconds_of([&] { renderer.render(scene, view); }));
        if (opengl) theirs.push_back(milliseconds_of([&] { opengl->render(view); }));
    }
    ours.erase(ours.begin());  // the first frame allocates
    std::printf("%s, %zu triangles\n", name, scene.triangles.size());
    const double median = print("zproof", ours);
    if (theirs.empty()) return;
    theirs.erase(theirs.begin());
    std::printf("  ratio %.2f\n", print("OpenGL", theirs) / median);
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : tbb::task_arena::automatic;
    tbb::task_arena arena(threads);
    const std::string_view only = argc > 2 ? argv[2] : "";
    const Beside beside = only.empty() ? Beside::opengl : Beside::nothing;
    std::printf("kernels: %s\n", rasterizer::instruction_set().c_str());
    arena.execute([&] {
        if (only.empty() || only == "room") time_scene("room", room(), beside);
        if (only.empty() || only == "ripples") time_scene("ripples", ripples(), beside);
        if (only.empty() || only == "soup") time_scene("soup", soup(), beside);
    });
}
