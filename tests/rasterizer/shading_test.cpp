#include "rasterizer/shader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rasterizer/rasterizer.h"
#include "rasterizer/surface.h"

namespace zproof::rasterizer {
namespace {

constexpr Light ambient_only{.ambient = 1, .diffuse = 0};

/// A rectangle in the plane z = 0 that an orthographic camera sees whole: raster (x, y) is uv (x, y) / size.
Scene facing_sheet() {
    Scene scene;
    scene.vertices.position_world = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    scene.vertices.uv = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    scene.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.parts = {{.node = "n", .mesh = "m", .first_triangle = 0, .triangle_count = 2}};
    scene.materials = {{}};
    return scene;
}

View facing_view(int size) {
    View view{.name = "v", .camera = {}, .width = size, .height = size};
    view.camera.eye_world = {0, 0, 3};
    view.camera.projection = Projection::parallel;
    return view;
}

Picture shaded(const Scene& scene, const View& view, const Light& light) {
    return shade(scene, view, render(scene, view), light);
}

TEST(Shading, PutsTexelsWhereTheirPixelsAre) {
    Scene scene = facing_sheet();
    Image image{.name = "i", .width = 8, .height = 8, .texels = {}};
    for (int i = 0; i < 64; ++i) {
        const auto code = std::uint8_t(4 * i);
        image.texels.insert(image.texels.end(), {code, std::uint8_t(255 - code), 0, 255});
    }
    scene.images = {image};
    scene.materials[0].base_color.image = 0;
    const auto linear = [](double code) {  // IEC 61966-2-1, written out once more
        const double c = code / 255;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    for (const Magnification filter : {Magnification::nearest, Magnification::linear}) {
        scene.materials[0].base_color.sampler.magnification = filter;
        const Picture picture = shaded(scene, facing_view(8), ambient_only);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                EXPECT_NEAR(picture.at(x, y).r, linear(4 * (8 * y + x)), 1e-6);
                EXPECT_NEAR(picture.at(x, y).g, linear(255 - 4 * (8 * y + x)), 1e-6);
            }
    }
}

TEST(Shading, TransformsTextureCoordinates) {
    Scene scene = facing_sheet();
    scene.images = {{.name = "i", .width = 2, .height = 1, .texels = {255, 0, 0, 255, 0, 0, 255, 255}}};
    Texture& texture = scene.materials[0].base_color;
    texture.image = 0;
    texture.sampler.magnification = Magnification::nearest;
    EXPECT_EQ(shaded(scene, facing_view(4), ambient_only).at(0, 0), (LinearRgb{1, 0, 0}));
    texture.transform.translation = {0.5, 0};
    EXPECT_EQ(shaded(scene, facing_view(4), ambient_only).at(0, 0), (LinearRgb{0, 0, 1}));
}

TEST(Shading, FollowsLambertAndTurnsNormalsToTheViewer) {
    Scene scene = facing_sheet();
    scene.materials[0].base_color_factor = {0.5f, 0.25f, 1, 1};
    const Light light{.toward_camera = {0.6, 0, 0.8}, .ambient = 0.125, .diffuse = 0.5};
    const double brightness = 0.125 + 0.5 * 0.8;
    const auto expect_lit = [&] {
        const LinearRgb seen = shaded(scene, facing_view(4), light).at(1, 2);
        EXPECT_NEAR(seen.r, 0.5 * brightness, 1e-6);
        EXPECT_NEAR(seen.g, 0.25 * brightness, 1e-6);
        EXPECT_NEAR(seen.b, brightness, 1e-6);
    };
    expect_lit();
    for (glm::uvec3& t : scene.triangles) std::swap(t.x, t.y);
    expect_lit();
    scene.vertices.normal_world.assign(4, glm::vec3{0, 0, -2});
    expect_lit();
    scene.vertices.normal_world.assign(4, glm::vec3{1, 0, 1});  // half-way to the right
    const double facing = (0.6 + 0.8) / std::sqrt(2.0);
    EXPECT_NEAR(shaded(scene, facing_view(4), light).at(1, 2).b, 0.125 + 0.5 * facing, 1e-6);
    scene.vertices.normal_world[1] = {0, 0, 0};  // no normal: the faces have their own
    expect_lit();
}

TEST(Shading, LeavesBackgroundBlack) {
    Scene scene = facing_sheet();
    View view = facing_view(8);
    view.camera.window = {-2, 2, -2, 2};
    EXPECT_EQ(shaded(scene, view, ambient_only).at(0, 0), LinearRgb{});
    EXPECT_EQ(shaded(scene, view, ambient_only).at(4, 4), (LinearRgb{1, 1, 1}));
}

/// Barycentrics against the point that they stand for: it must lie on the view ray.
TEST(Surface, BarycentricsNameThePointOnTheViewRay) {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> place{-4, 4};
    const auto point = [&] { return glm::dvec3{place(random), place(random), place(random)}; };
    for (const Projection projection : {Projection::perspective, Projection::parallel})
        for (int i = 0; i < 1000; ++i) {
            View view{.name = "v", .camera = {}, .width = 64, .height = 48};
            view.camera.projection = projection;
            view.camera.window = {-0.5, 1.5, -1, 0.25};
            if (projection == Projection::parallel) view.camera.shear = {0.5, -0.25};
            const PixelRay line = pixel_ray(view, 64 * (place(random) + 4) / 8, 48 * (place(random) + 4) / 8);
            const std::array corners{point(), point(), point()};
            const Barycentrics b = barycentrics(line, corners);
            const glm::dvec3 on_triangle = blended(b, corners), from_line = on_triangle - line.from;
            EXPECT_NEAR(b[0] + b[1] + b[2], 1, 1e-12);
            const double size = glm::length(from_line) * (std::abs(b[0]) + std::abs(b[1]) + std::abs(b[2]));
            EXPECT_LE(glm::length(glm::cross(from_line, glm::normalize(line.to))), 1e-9 * (1 + size));
        }
}

}  // namespace
}  // namespace zproof::rasterizer
