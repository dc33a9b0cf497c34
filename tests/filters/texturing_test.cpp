#include "rasterizer/texturing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "filters/methods/catalogue.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/shader.h"
#include "rasterizer/surface.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/suite.h"

namespace zproof::rasterizer {
namespace {

constexpr int texture_width = 8, texture_height = 4;

/// One triangle with a texture, anywhere before or behind the eye.
Scene triangle_with_texture(const std::array<glm::vec3, 3>& corners) {
    Scene scene;
    scene.vertices.position_world = {corners[0], corners[1], corners[2]};
    scene.vertices.uv = {{{0.25f, 0.5f}, {3, -1}, {-2, 1.5f}}};
    scene.triangles = {{0, 1, 2}};
    scene.parts = {{.node = "n", .mesh = "m", .first_triangle = 0, .triangle_count = 1}};
    scene.images = {{.name = "i", .width = texture_width, .height = texture_height, .texels = {}}};
    scene.images[0].texels.assign(4 * texture_width * texture_height, 128);
    scene.materials = {{}};
    Texture& texture = scene.materials[0].base_color;
    texture.image = 0;
    texture.transform = {.linear = glm::dmat2{0.5, 1, -1, 2}, .translation = {3, 4}};
    return scene;
}

glm::dvec2 texel_of(const Scene& scene, int corner) {
    const UvTransform& t = scene.materials[0].base_color.transform;
    const glm::dvec2 uv{scene.vertices.uv[0][std::size_t(corner)]};
    return (t.translation + t.linear * uv) * glm::dvec2{texture_width, texture_height};
}

View view_of(Projection projection) {
    View view{.name = "v", .camera = {}, .width = 64, .height = 48};
    view.camera.eye_world = {0.5f, -0.25f, 1};
    view.camera.projection = projection;
    view.camera.window = {-0.5, 1.5, -1, 0.25};
    if (projection == Projection::parallel) view.camera.shear = {0.5, -0.25};
    return view;
}

glm::dvec2 at(const Homography<double>& map, const glm::dvec2& p_raster) {
    const auto [u, v] = map.at(p_raster.x, p_raster.y);
    return {u, v};
}

/// Where the camera's own definition (scenes/camera.h) puts a point of the world.
glm::dvec2 raster_of(const View& view, const glm::dvec3& p_world) {
    const Camera& c = view.camera;
    const glm::dvec3 d = p_world - glm::dvec3{c.eye_world};
    const double t = -glm::dot(d, c.back);
    const glm::dvec2 p{glm::dot(d, c.right), glm::dot(d, c.up)};
    const glm::dvec2 w = c.projection == Projection::perspective ? p / t : p - t * c.shear;
    return {(w.x - c.window.left) / (c.window.right - c.window.left) * view.width,
            (c.window.top - w.y) / (c.window.top - c.window.bottom) * view.height};
}

class EveryProjection : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(TexelMap, EveryProjection,
                         testing::Values(Projection::perspective, Projection::parallel));

/// A point of the triangle, drawn where the camera puts it, is read where its barycentrics put it.
TEST_P(EveryProjection, PutsPointsOfTheTriangleOnTheirTexels) {
    std::mt19937 random{11};
    std::uniform_real_distribution<float> place{-4, 4}, share{0, 1};
    for (int i = 0; i < 2000; ++i) {
        const auto corner = [&] { return glm::vec3{place(random), place(random), place(random) - 5}; };
        const Scene scene = triangle_with_texture({corner(), corner(), corner()});
        const View view = view_of(GetParam());
        const double b = share(random), c = (1 - b) * share(random);
        const auto blend = [&](const auto& of) { return (1 - b - c) * of(0) + b * of(1) + c * of(2); };
        const glm::dvec3 p_world =
            blend([&](int k) { return glm::dvec3{scene.vertices.position_world[std::size_t(k)]}; });
        const glm::dvec2 texel = blend([&](int k) { return texel_of(scene, k); });
        const auto map = texels_from_raster(scene, view, 0);
        ASSERT_TRUE(map);
        const glm::dvec2 p_raster = raster_of(view, p_world);
        const glm::dvec3 n =
            glm::cross(glm::dvec3{scene.vertices.position_world[1] - scene.vertices.position_world[0]},
                       glm::dvec3{scene.vertices.position_world[2] - scene.vertices.position_world[0]});
        const PixelRay line = pixel_ray(view, p_raster.x, p_raster.y);
        const double grazing = std::abs(glm::dot(glm::normalize(n), glm::normalize(line.to)));
        if (grazing < 1e-3) continue;  // the picture holds no more than 1 / grazing of the digits
        EXPECT_LE(glm::distance(at(*map, p_raster), texel), 1e-9 / grazing) << "triangle " << i;
        const double depth = -glm::dot(p_world - glm::dvec3{view.camera.eye_world}, view.camera.back);
        const double expected_w = GetParam() == Projection::perspective ? 1 / depth : 1;
        EXPECT_NEAR(map->w.at(p_raster.x, p_raster.y), expected_w, 1e-9 / grazing) << "triangle " << i;
    }
}

TEST_P(EveryProjection, AffineMeetsTheCornersAndTheMiddlesOfTheirPictures) {
    const Scene scene = triangle_with_texture({{{-1, -1, -2}, {2, 0, -5}, {0, 1, -9}}});
    const View view = view_of(GetParam());
    const auto p_raster = [&](int k) {
        return raster_of(view, glm::dvec3{scene.vertices.position_world[std::size_t(k)]});
    };
    const auto map = affine_texels_from_raster(scene, view, 0, p_raster(0));
    ASSERT_TRUE(map);
    for (int k = 0; k < 3; ++k) {
        EXPECT_LE(glm::distance(at(*map, p_raster(k)), texel_of(scene, k)), 1e-10);
        const int next = (k + 1) % 3;
        EXPECT_LE(glm::distance(at(*map, (p_raster(k) + p_raster(next)) / 2.0),
                                (texel_of(scene, k) + texel_of(scene, next)) / 2.0),
                  1e-10);
    }
}

/// Affine and perspective agree where all depths are one, and only there.
TEST(TexelMap, AffineIsRightWhereDepthIsConstant) {
    const View view = view_of(Projection::perspective);
    const glm::dvec2 p{30, 30};
    const Scene level = triangle_with_texture({{{-1, -1, -2}, {2, 0, -2}, {0, 1, -2}}});
    EXPECT_LE(glm::distance(at(*affine_texels_from_raster(level, view, 0, p), p),
                            at(*texels_from_raster(level, view, 0), p)),
              1e-10);
    const Scene tilted = triangle_with_texture({{{-1, -1, -2}, {2, 0, -5}, {0, 1, -9}}});
    EXPECT_GE(glm::distance(at(*affine_texels_from_raster(tilted, view, 0, p), p),
                            at(*texels_from_raster(tilted, view, 0), p)),
              0.5);
}

/// Both halves of a triangle that the near plane cuts into a quad meet its corners in front.
TEST(TexelMap, AffineOfATriangleThroughTheNearPlaneHoldsItsCornersInFront) {
    View view = view_of(Projection::perspective);
    view.camera.near_depth = 0.5;
    const Scene scene = triangle_with_texture({{{0.5f, -0.2f, 3}, {2, -1, -5}, {0, -1, -9}}});
    for (int k : {1, 2}) {
        const glm::dvec2 p = raster_of(view, glm::dvec3{scene.vertices.position_world[std::size_t(k)]});
        const auto map = affine_texels_from_raster(scene, view, 0, p);
        ASSERT_TRUE(map);
        EXPECT_LE(glm::distance(at(*map, p), texel_of(scene, k)), 1e-9) << "corner " << k;
    }
    // Depth runs from 10 at corner 2 to -2 at corner 0: the second triangle of the fan ends where it is near.
    const double share = (10 - 0.5) / 12;
    const glm::dvec3 cut_world = glm::mix(glm::dvec3{scene.vertices.position_world[2]},
                                          glm::dvec3{scene.vertices.position_world[0]}, share);
    const glm::dvec2 cut_raster = raster_of(view, cut_world);
    EXPECT_LE(glm::distance(at(*affine_texels_from_raster(scene, view, 0, cut_raster), cut_raster),
                            glm::mix(texel_of(scene, 2), texel_of(scene, 0), share)),
              1e-9);
    const Scene behind = triangle_with_texture({{{0, 0, 3}, {2, -1, 5}, {0, -1, 2}}});
    EXPECT_FALSE(affine_texels_from_raster(behind, view, 0, {3, 3}));
}

TEST(TexelMap, IsNoneWhereNothingIsTextured) {
    const View view = view_of(Projection::perspective);
    Scene scene = triangle_with_texture({{{-1, -1, -2}, {2, 0, -5}, {0, 1, -9}}});
    scene.materials[0].base_color.uv_set = 1;
    EXPECT_FALSE(texels_from_raster(scene, view, 0));
    scene.materials[0].base_color = {};
    EXPECT_FALSE(texels_from_raster(scene, view, 0));
    const glm::vec3 eye = view.camera.eye_world;
    const Scene edge_on = triangle_with_texture(
        {eye + glm::vec3{0, 1, -2}, eye + glm::vec3{0, 1, -4}, eye + glm::vec3{0, -2, -3}});
    EXPECT_FALSE(texels_from_raster(edge_on, view, 0));
}

/// Two ways to the same colours: shading under white light, and filtering.
TEST(Texturing, LevelZeroFiltersPaintWhatShadingDoes) {
    Loaded loaded = generate_suite_scene("textured_ground", 160, 90);
    for (const auto& [name, magnification] :
         {std::pair{"nearest", Magnification::nearest}, std::pair{"bilinear", Magnification::linear}}) {
        for (Material& material : loaded.scene.materials)
            material.base_color.sampler.magnification = magnification;
        for (const View& view : loaded.views) {
            const Frame frame = render(loaded.scene, view);
            const Picture shaded = shade(loaded.scene, view, frame, Light{.ambient = 1, .diffuse = 0});
            const Picture picture =
                filtered(loaded.scene, view, frame, {.method = *texture::find_method(name)});
            int apart = 0;
            for (int y = 0; y < view.height; ++y)
                for (int x = 0; x < view.width; ++x)
                    apart += std::abs(shaded.at(x, y).g - picture.at(x, y).g) > 1e-6f;
            EXPECT_EQ(apart, 0) << name << ", " << view.name;
        }
    }
}

Picture filtered_by(const char* method, const Loaded& loaded) {
    const View& view = loaded.views[0];
    return filtered(loaded.scene, view, render(loaded.scene, view),
                    {.method = *texture::find_method(method)});
}

/// A square that shows a texture of noise once, and one beside it that shows it four times.
Loaded evenly_shown() {
    Loaded loaded = generate_filter_scene("uneven_strips", 96, 64);
    Scene& scene = loaded.scene;
    scene.vertices.position_world.clear();
    scene.vertices.uv[0].clear();
    for (const float left : {-1.0f, 0.0f})
        for (const glm::vec2 corner : {glm::vec2{0, 0}, glm::vec2{0, 1}, glm::vec2{1, 1}, glm::vec2{1, 0}}) {
            scene.vertices.position_world.push_back({left + corner.x, 0.5f - corner.y, -1});
            scene.vertices.uv[0].push_back(corner * (left + 2));
        }
    scene.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    scene.parts.resize(1);
    scene.parts[0].triangle_count = 4;
    return loaded;
}

TEST(ParameterizationAware, IsPlainWhereTexelsCoverTheSame) {
    const Loaded loaded = evenly_shown();
    EXPECT_TRUE(std::ranges::equal(filtered_by("trilinear-parameterization-aware", loaded).pixels(),
                                   filtered_by("trilinear-gl", loaded).pixels()));
}

/// Eight textures across a field of 162 pixels: every level read has texels of 16 columns and more, a dark
/// strip and a light one. Their means are 0.15 and 0.75, that of the surface is (0.15 + 4 * 0.75) / 5.
TEST(ParameterizationAware, ShowsTheSurfacesMeanWhereTexelsDiffer) {
    const Loaded loaded = generate_filter_scene("uneven_strips", 512, 512);
    const Picture aware = filtered_by("trilinear-parameterization-aware", loaded),
                  plain = filtered_by("trilinear-gl", loaded);
    for (int x = 350; x < 500; ++x) {
        EXPECT_NEAR(aware.at(x, 384).g, 0.63, 0.02) << x;
        EXPECT_NEAR(plain.at(x, 384).g, 0.45, 0.02) << x;
    }
}

}  // namespace
}  // namespace zproof::rasterizer
