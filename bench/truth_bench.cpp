// What the exact area integral costs per pixel: processor time of one thread on a checker plane to the
// horizon with one 512 x 512 texture, row by row. A figure for people: nothing depends on it.
//
//     truth_bench [WIDTH HEIGHT [TEXELS_PER_UNIT]]     256 256 128 where nothing is said
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <vector>

#include "oracle/area_integral.h"

namespace {

using namespace zproof;

constexpr int texture_side = 512, check = 32;

Image checks() {
    Image image{.name = "checks", .width = texture_side, .height = texture_side, .texels = {}};
    for (int row = 0; row < texture_side; ++row)
        for (int column = 0; column < texture_side; ++column) {
            const auto grey = std::uint8_t((column / check + row / check) % 2 == 0 ? 255 : 0);
            image.texels.insert(image.texels.end(), {grey, grey, grey, 255});
        }
    return image;
}

/// The plane y = 0, 2048 units in every direction.
Scene plane(double texels_per_unit) {
    Scene scene;
    scene.vertices.uv.resize(1);
    for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        scene.vertices.position_world.push_back({2048 * corner.x, 0, 2048 * corner.y});
        scene.vertices.uv[0].push_back(2048.0f * corner);
    }
    scene.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.parts.push_back({.node = "plane", .mesh = "plane", .triangle_count = 2});
    scene.materials.emplace_back();
    scene.materials[0].base_color.image = 0;
    scene.materials[0].base_color.transform = {glm::dmat2(texels_per_unit / texture_side),
                                               glm::dvec2(3.37, 1.71) / double(texture_side)};
    scene.images.push_back(checks());
    return scene;
}

/// One row of the image of an eye at height 1, pitched down by 20 degrees, 60 degrees high.
View row_view(int width, int height, int row) {
    constexpr double degree = std::numbers::pi / 180;
    View view{.name = "row", .camera = {}, .width = width, .height = 1};
    view.camera = look_at({0, 1, 0}, {0, 1 - std::sin(20 * degree), -std::cos(20 * degree)}, {0, 1, 0});
    Window window = symmetric_window(60 * degree, double(width) / height);
    const double px = (window.top - window.bottom) / height;
    window.top -= px * row;
    window.bottom = window.top - px;
    view.camera.window = window;
    view.camera.near_depth = 1e-3;
    view.camera.far_depth = 1e6;
    return view;
}

struct RowCost {
    int row = 0;
    double us_per_px = 0;
};

double seconds_of(const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

void report(std::vector<RowCost> rows, const char* name) {
    double sum = 0;
    for (const RowCost& r : rows) sum += r.us_per_px;
    std::vector<RowCost> sorted = rows;
    std::ranges::sort(sorted, {}, &RowCost::us_per_px);
    std::printf("%-9s mean %8.2f, median %8.2f us per pixel; rows nearest to the horizon:", name,
                sum / double(rows.size()), sorted[sorted.size() / 2].us_per_px);
    for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 10); ++i)
        std::printf(" %.0f", rows[i].us_per_px);
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int width = argc > 1 ? std::atoi(argv[1]) : 256, height = argc > 2 ? std::atoi(argv[2]) : 256;
    const Scene scene = plane(argc > 3 ? std::atof(argv[3]) : 128);
    tbb::task_arena(1).execute([&] {
        for (const auto& [what, name] : {std::pair{oracle::Reconstruction::nearest, "nearest"},
                                         {oracle::Reconstruction::bilinear, "bilinear"},
                                         {oracle::Reconstruction::gaussian, "gaussian"}}) {
            const double setting_up = [&] {
                const View nothing = row_view(width, height, -2 * height);  // above the horizon
                return seconds_of([&] { oracle::area_truth(scene, nothing, what); });
            }();
            std::vector<RowCost> rows;
            for (int y = 0; y < height; ++y) {
                const View view = row_view(width, height, y);
                oracle::AreaTruth truth;
                const double seconds = seconds_of([&] { truth = oracle::area_truth(scene, view, what); });
                const auto kinds = truth.kind.pixels();
                if (std::ranges::count(kinds, oracle::TruthKind::background) == width) continue;
                rows.push_back({y, 1e6 * (seconds - setting_up) / width});
            }
            report(rows, name);
        }
    });
}
