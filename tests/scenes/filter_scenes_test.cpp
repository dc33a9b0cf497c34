// What holds for every scene that texture filters are compared on.
#include "scenes/filters/filter_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scenes/filters/textures.h"
#include "scenes/scene_error.h"
#include "tests/support/worked_setup.h"
#include "texture/texels.h"

namespace zproof {
namespace {

TEST(FilterScenes, HaveUniqueNames) {
    std::set<std::string> names;
    for (const FilterSceneEntry& entry : filter_scenes())
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
}

TEST(FilterScenes, RefuseAnUnknownName) {
    try {
        generate_filter_scene("no_such");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("'no_such'"), std::string::npos);
    }
    EXPECT_THROW(generate_filter_scene("worked", 0, 5), SceneError);
    EXPECT_THROW(photograph_scene("/no/such/file.png"), SceneError);
}

class EveryFilterScene : public testing::TestWithParam<FilterSceneEntry> {};

TEST_P(EveryFilterScene, IsWhole) {
    const Loaded loaded = generate_filter_scene(GetParam().name, 96, 64);
    const Scene& scene = loaded.scene;
    EXPECT_EQ(scene.name, GetParam().name);
    for (const Part& part : scene.parts)
        EXPECT_TRUE(0 <= part.material && std::size_t(part.material) < scene.materials.size()) << part.node;
    ASSERT_EQ(scene.vertices.uv.size(), 1u);
    EXPECT_EQ(scene.vertices.uv[0].size(), scene.vertices.position_world.size());
    for (const glm::uvec3& triangle : scene.triangles)
        for (int corner = 0; corner < 3; ++corner)
            EXPECT_LT(triangle[corner], scene.vertices.position_world.size());
    for (const Material& material : scene.materials)
        EXPECT_TRUE(0 <= material.base_color.image &&
                    std::size_t(material.base_color.image) < scene.images.size());
    for (const Image& image : scene.images)
        EXPECT_EQ(image.texels.size(), 4 * std::size_t(image.width) * std::size_t(image.height));
}

TEST_P(EveryFilterScene, HasViewsOfItsOwn) {
    const Loaded loaded = generate_filter_scene(GetParam().name, 96, 64);
    std::set<std::string> names;
    for (const View& view : loaded.views) {
        validate(view.camera);
        EXPECT_EQ(view.width, 96);
        EXPECT_EQ(view.height, 64);
        EXPECT_TRUE(names.insert(view.name).second) << view.name;
    }
    EXPECT_FALSE(names.empty());
}

TEST_P(EveryFilterScene, HasTheSameBitsEveryTime) {
    const Scene a = generate_filter_scene(GetParam().name, 96, 64).scene,
                b = generate_filter_scene(GetParam().name, 96, 64).scene;
    EXPECT_EQ(a.vertices.position_world, b.vertices.position_world);
    EXPECT_EQ(a.vertices.uv, b.vertices.uv);
    for (std::size_t i = 0; i < a.images.size(); ++i) EXPECT_EQ(a.images[i].texels, b.images[i].texels);
}

/// Texels step by at most one part in eight from a border to the one that follows it round the corner, for
/// textures that are smooth; a seam of its own would show as an edge that no filter is to blame for.
TEST(FilterTextures, OfNoiseAndRingsHaveNoSeam) {
    for (const Image& image : {filters::zone_plate(), filters::pink_noise({257, 129})}) {
        double widest_step = 0, step_at_seam = 0;
        const auto at = [&](int column, int row) {
            return texture::linear_from_srgb(
                image.texels[4 * (std::size_t(row) * std::size_t(image.width) + std::size_t(column))]);
        };
        for (int row = 0; row < image.height; ++row) {
            for (int column = 0; column + 1 < image.width; ++column)
                widest_step = std::max(widest_step, std::abs(at(column + 1, row) - at(column, row)));
            step_at_seam = std::max(step_at_seam, std::abs(at(0, row) - at(image.width - 1, row)));
        }
        EXPECT_LE(step_at_seam, widest_step) << image.name;
    }
}

TEST(FilterTextures, InvertTheSrgbCurve) {
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(filters::srgb_code(texture::linear_from_srgb(std::uint8_t(code))), code);
}

TEST(FilterTextures, OfChecksAreHalfWhite) {
    for (const auto& [width, height] : {std::pair{512, 512}, std::pair{640, 427}}) {
        const Image image = filters::checks({width, height});
        double sum = 0;
        int between = 0;
        for (std::size_t i = 0; i < image.texels.size(); i += 4) {
            sum += texture::linear_from_srgb(image.texels[i]);
            between += image.texels[i] != 0 && image.texels[i] != 255;
        }
        const double texels = double(width) * height;
        EXPECT_NEAR(sum / texels, 0.5, 0.5 / 255 * between / texels + 1 / texels);
        EXPECT_EQ(between,
                  18 * height + 14 * width - 18 * 14);  // each edge crosses texels, none lies between two
    }
}

TEST(FilterScenes, WorkedIsTheWorkedSetUp) {
    const Loaded loaded = generate_filter_scene("worked", texture::worked::side, texture::worked::side);
    ASSERT_EQ(loaded.views.size(), 13u);
    const UvTransform& transform = loaded.scene.materials[0].base_color.transform;
    for (std::size_t i = 0; i < 13; ++i) {
        const View& view = loaded.views[i];
        const auto map = texture::worked::texels_from_raster(7.5 * double(i));
        for (int y = texture::worked::first_row; y < 256; y += 19)
            for (int x = 0; x < 256; x += 15) {
                // The camera's own definition (scenes/camera.h), met with y = 0; the vertices' uv is (x, -z).
                const Camera& c = view.camera;
                const double u = c.window.left + (c.window.right - c.window.left) * (x + 0.5) / 256,
                             v = c.window.top - (c.window.top - c.window.bottom) * (y + 0.5) / 256;
                const glm::dvec3 d = u * c.right + v * c.up - c.back,
                                 p = glm::dvec3(c.eye_world) - d * (1 / d.y);
                const glm::dvec2 place =
                    512.0 * (transform.translation + transform.linear * glm::dvec2{p.x, -p.z});
                const auto [column, row] = map.at(x + 0.5, y + 0.5);
                // Rounding of a slope of 1/60 at a distance of 60 units, 128 texels each.
                EXPECT_NEAR(place.x, column, 1e-9) << view.name;
                EXPECT_NEAR(place.y, row, 1e-9) << view.name;
            }
    }
    const Image& checks = loaded.scene.images[0];
    const texture::LinearImage expected = texture::worked::checks();
    for (std::size_t i = 0; i < expected.texels.size(); ++i)
        ASSERT_EQ(checks.texels[4 * i], 255 * int(expected.texels[i].r));
}

/// The file that is written of a scene is of 512 x 512 pixels; whoever draws it at 256 draws the same scene.
/// The three other charts hold a footprint in pixels, and so are laid out for their picture.
TEST(FilterScenes, AreTheSameAtEverySizeButForChartsOfFootprints) {
    const std::set<std::string> of_footprints{"tilted_quads", "lod_ramp", "magnification"};
    for (const FilterSceneEntry& entry : filter_scenes()) {
        const Scene natural = generate_filter_scene(entry.name).scene,
                    small = generate_filter_scene(entry.name, 256, 200).scene;
        const bool is_same = natural.vertices.position_world == small.vertices.position_world &&
                             natural.vertices.uv == small.vertices.uv;
        EXPECT_EQ(is_same, !of_footprints.contains(entry.name)) << entry.name;
    }
}

/// What a filter keeps of a texture is counted once per material.
TEST(FilterScenes, ShareMaterialsBetweenFieldsOfOneTexture) {
    EXPECT_EQ(generate_filter_scene("tilted_quads", 96, 64).scene.materials.size(), 1u);
    EXPECT_EQ(generate_filter_scene("magnification", 96, 64).scene.materials.size(), 3u);
    EXPECT_EQ(generate_filter_scene("seams", 96, 64).scene.materials.size(), 9u);
}

TEST(FilterScenes, TakeAPhotograph) {
    const Loaded loaded = photograph_scene(ZPROOF_SHARED "/models/textures/rocket.jpg", 64, 64);
    EXPECT_EQ(loaded.scene.name, "rocket.jpg");
    EXPECT_EQ(loaded.scene.images[0].width, 640);
    EXPECT_EQ(loaded.scene.images[0].height, 427);
    EXPECT_EQ(loaded.views.size(), 13u);
}

INSTANTIATE_TEST_SUITE_P(FilterScenes, EveryFilterScene, testing::ValuesIn(filter_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace zproof
