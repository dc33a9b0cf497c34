// What the exact area integral costs per pixel: processor time of one thread on a checker plane to the
// horizon with one 512 x 512 texture, by rows. 's': estimated by samples. A figure for people: nothing
// depends on it.
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
constexpr int worked_row = 56;  ///< of 256: where the worked set-up begins to count

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

/// Rows `first` to `first + count - 1` of the image of an eye at height 1, pitched down by 20 degrees, 60
/// high.
View band_view(Resolution size, int first, int count) {
    constexpr double degree = std::numbers::pi / 180;
    View view{.name = "band", .camera = {}, .width = size.width, .height = count};
    view.camera = look_at({0, 1, 0}, {0, 1 - std::sin(20 * degree), -std::cos(20 * degree)}, {0, 1, 0});
    Window& window = view.camera.window = symmetric_window(60 * degree, double(size.width) / size.height);
    const double px = (window.top - window.bottom) / size.height;
    window.top -= px * first;
    window.bottom = window.top - px * count;
    view.camera.near_depth = 1e-3;
    view.camera.far_depth = 1e6;
    return view;
}

struct Timed {
    oracle::AreaTruth truth;
    double seconds = 0;
};

/// The best of so many runs.
Timed timed(const Scene& scene, const View& view, oracle::Reconstruction what, int runs) {
    Timed best{{}, 1e300};
    for (int i = 0; i < runs; ++i) {
        const std::clock_t start = std::clock();
        best.truth = oracle::area_truth(scene, view, what);
        best.seconds = std::min(best.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

/// Microseconds per pixel of a band, the texture's preparation not counted.
double us_per_px(const Timed& band, double setting_up) {
    return 1e6 * (band.seconds - setting_up) / double(band.truth.kind.size().pixel_count());
}

void report(const Scene& scene, Resolution size, oracle::Reconstruction what, const char* name) {
    const double setting_up = timed(scene, band_view(size, -4 * size.height, 1), what, 9).seconds;
    std::printf("%-9s texture %.1f ms;", name, 1e3 * setting_up);
    const int horizon =
        int(size.height * (0.5 - std::tan(std::numbers::pi / 9) / 2 / std::tan(std::numbers::pi / 6)));
    std::printf(" rows from the horizon, us per pixel:");
    for (int row = horizon; row < horizon + 8; ++row) {
        const Timed band = timed(scene, band_view(size, row, 1), what, 1);
        const auto sampled = std::ranges::count(band.truth.kind.pixels(), oracle::TruthKind::sampled);
        std::printf(" %.0f%s", us_per_px(band, setting_up), sampled > 0 ? "s" : "");
    }
    const int below = size.height * worked_row / 256;
    const Timed whole = timed(scene, band_view(size, below, size.height - below), what, 3);
    std::printf("\n          below row %d: mean %.2f us per pixel, the texture's preparation counted\n",
                below, us_per_px(whole, 0));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const Resolution size{argc > 1 ? std::atoi(argv[1]) : 256, argc > 2 ? std::atoi(argv[2]) : 256};
    const Scene scene = plane(argc > 3 ? std::atof(argv[3]) : 128);
    tbb::task_arena(1).execute([&] {
        report(scene, size, oracle::Reconstruction::nearest, "nearest");
        report(scene, size, oracle::Reconstruction::bilinear, "bilinear");
        report(scene, size, oracle::Reconstruction::gaussian, "gaussian");
    });
}
