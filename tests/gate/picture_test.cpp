// Shading and texturing against POV-Ray's, which shares no code with ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "compare/picture_difference.h"
#include "oracle/povray.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/shader.h"

namespace zproof {
namespace {

/// POV-Ray's picture has 16 bits a channel: a step for its rounding or cutting, half a step for the texels
/// that it was given, half a step for its float32 colours.
constexpr double largest_difference = 2.0 / 65535;

Image noise(int width, int height) {
    std::mt19937 random{11};
    Image image{.name = "noise", .width = width, .height = height, .texels = {}};
    for (int i = 0; i < 4 * width * height; ++i) image.texels.push_back(std::uint8_t(random() >> 24));
    return image;
}

/// A sheet of 4 x 4 squares, bent into a wave, with coordinates that reach beyond the texture on all sides.
Scene wave() {
    Scene scene;
    scene.vertices.uv.emplace_back();
    for (int row = 0; row <= 4; ++row)
        for (int column = 0; column <= 4; ++column) {
            const float x = float(column) / 2 - 1, y = 1 - float(row) / 2;
            scene.vertices.position_world.emplace_back(x, y, 0.3f * std::sin(2 * x + y));
            scene.vertices.uv[0].emplace_back(0.8f * float(column) - 1.1f, 0.7f * float(row) - 0.9f);
        }
    for (std::uint32_t row = 0; row < 4; ++row)
        for (std::uint32_t column = 0; column < 4; ++column) {
            const std::uint32_t corner = 5 * row + column;
            scene.triangles.emplace_back(corner, corner + 5, corner + 6);
            scene.triangles.emplace_back(corner, corner + 6, corner + 1);
        }
    scene.parts = {{.node = "n", .mesh = "m", .first_triangle = 0, .triangle_count = 32}};
    scene.materials = {{.name = "", .base_color_factor = {0.9f, 0.7f, 0.5f, 1}, .base_color = {}}};
    return scene;
}

View some_view(Projection projection) {
    View view{
        .name = "v", .camera = look_at({0.5, 0.4, 2.5}, {0, 0, 0}, {0, 1, 0}), .width = 96, .height = 64};
    view.camera.projection = projection;
    view.camera.window =
        projection == Projection::perspective ? Window{-0.6, 0.6, -0.4, 0.4} : Window{-1.5, 1.5, -1, 1};
    return view;
}

/// Over the pixels at which our frame and POV-Ray's name the same triangle.
PictureDifference difference(const Scene& scene, const View& view) {
    const oracle::PovRay povray{scene};
    const Frame ours = rasterizer::render(scene, view), theirs = povray.render(view);
    Plane<PixelClass> classes(ours.size(), PixelClass::edge);
    std::ranges::transform(
        ours.primitive.pixels(), theirs.primitive.pixels(), classes.pixels().begin(),
        [](PrimitiveId a, PrimitiveId b) { return a == b ? PixelClass::agree : PixelClass::edge; });
    const Picture shaded = rasterizer::shade(scene, view, ours, Light{});
    return differences(shaded, povray.picture(view, Light{}), classes)[std::size_t(PixelClass::agree)];
}

void expect_same(const Scene& scene, const View& view) {
    const PictureDifference d = difference(scene, view);
    EXPECT_GT(d.pixels, std::uint64_t(view.width) * std::uint64_t(view.height) * 95 / 100);
    EXPECT_LE(d.largest, largest_difference);
    EXPECT_GT(d.largest, 0);  // two renderers, not one
}

TEST(Pictures, FlatColoursAreThoseOfPovRay) {
    expect_same(wave(), some_view(Projection::perspective));
    expect_same(wave(), some_view(Projection::parallel));
}

TEST(Pictures, TexturesAreThoseOfPovRayForEveryWrapAndFilter) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
        for (const Magnification filter : {Magnification::nearest, Magnification::linear}) {
            SCOPED_TRACE(int(wrap) * 10 + int(filter));
            Scene scene = wave();
            scene.images = {noise(7, 5)};
            Texture& texture = scene.materials[0].base_color;
            texture.image = 0;
            texture.sampler = {wrap, wrap, Minification::linear, filter};
            texture.transform.linear = {{0.9, 0.2}, {-0.1, 1.1}};
            texture.transform.translation = {0.13, 0.29};
            expect_same(scene, some_view(Projection::perspective));
        }
}

TEST(Pictures, SmoothNormalsAreThoseOfPovRay) {
    Scene scene = wave();
    for (const glm::vec3& p : scene.vertices.position_world)
        scene.vertices.normal_world.push_back(
            glm::normalize(glm::vec3(-0.6f * std::cos(2 * p.x + p.y), -0.3f * std::cos(2 * p.x + p.y), 1)));
    expect_same(scene, some_view(Projection::perspective));
    scene.vertices.normal_world[12] = {};  // its triangles have no normals of their own any more
    expect_same(scene, some_view(Projection::parallel));
}

TEST(Pictures, VertexColoursAreThoseOfPovRay) {
    Scene scene = wave();
    for (const glm::vec3& p : scene.vertices.position_world)
        scene.vertices.color.emplace_back(0.5f + p.x / 2, 0.5f + p.y / 2, 0.25f, 1);
    expect_same(scene, some_view(Projection::perspective));
}

}  // namespace
}  // namespace zproof
