// The exact area integral of every pixel of a checker plane to the horizon with one 512 x 512 texture, below
// the row where the worked set-up begins to count; the texture's preparation is counted.
#include <cmath>
#include <numbers>

#include "bench/lazy.h"
#include "bench/suites.h"
#include "filters/area/area_integral.h"

namespace zproof::bench {
namespace {

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

void add_truth(const std::string& name, oracle::Reconstruction what) {
    constexpr Resolution size{.width = 256, .height = 256};
    const Lazy<Scene> scene{[] { return plane(128); }};
    const View view = band_view(size, worked_row, size.height - worked_row);
    add("truth/" + name + "/zproof",
        [=] { benchmark::DoNotOptimize(oracle::area_truth(*scene, view, what)); },
        {"pixels", double(view.width) * view.height});
}

}  // namespace

void add_truth() {
    add_truth("nearest", oracle::Reconstruction::nearest);
    add_truth("bilinear", oracle::Reconstruction::bilinear);
    add_truth("gaussian", oracle::Reconstruction::gaussian);
    add_truth("mitchell", oracle::Reconstruction::mitchell);
    add_truth("blackman_harris", oracle::Reconstruction::blackman_harris);
}

}  // namespace zproof::bench
