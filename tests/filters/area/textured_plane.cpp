#include "textured_plane.h"

#include <cmath>
#include <numbers>

#include "tests/oracle/scenes_at_random.h"

namespace zproof::oracle {

namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

Image image_of(int width, int height, const std::vector<std::uint8_t>& grey) {
    Image image{.name = "grey", .width = width, .height = height, .texels = {}};
    for (const std::uint8_t g : grey) image.texels.insert(image.texels.end(), {g, g, g, 255});
    return image;
}

Image checks(int side, int check) {
    std::vector<std::uint8_t> grey;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            grey.push_back((column / check + row / check) % 2 == 0 ? 255 : 0);
    return image_of(side, side, grey);
}

Image noise(int width, int height, std::uint32_t seed) {
    Rng rng(seed);
    Image image{.name = "noise", .width = width, .height = height, .texels = {}};
    for (int i = 0; i < width * height; ++i)
        for (int channel = 0; channel < 4; ++channel)
            image.texels.push_back(std::uint8_t(rng.between(0, 256)));
    return image;
}

Scene textured_plane(float reach, const PlaneTexture& texture) {
    Scene scene;
    scene.name = "textured_plane";
    scene.vertices.uv.resize(1);
    for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        scene.vertices.position_world.push_back({reach * corner.x, 0, reach * corner.y});
        scene.vertices.uv[0].push_back(reach * corner);
    }
    scene.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.parts.push_back({.node = "plane", .mesh = "plane", .triangle_count = 2});
    const double c = texture.per_unit * std::cos(texture.phi_degrees * degree),
                 s = texture.per_unit * std::sin(texture.phi_degrees * degree);
    Material material;
    material.base_color.image = 0;
    material.base_color.sampler.wrap_u = material.base_color.sampler.wrap_v = texture.wrap;
    material.base_color.transform = {glm::dmat2(c, s, -s, c), texture.offset};
    scene.materials.push_back(material);
    scene.images.push_back(texture.image);
    return scene;
}

View ground_view(int width, int height, double pitch_degrees) {
    View view{.name = "ground", .camera = {}, .width = width, .height = height};
    const double c = std::cos(pitch_degrees * degree), s = std::sin(pitch_degrees * degree);
    view.camera.eye_world = {0, 1, 0};
    view.camera.right = {1, 0, 0};
    view.camera.up = {0, c, -s};
    view.camera.back = {0, s, c};
    view.camera.window = symmetric_window(60 * degree, double(width) / height);
    view.camera.near_depth = 1e-3;
    view.camera.far_depth = 1e6;
    return view;
}

}  // namespace zproof::oracle
