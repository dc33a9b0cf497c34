/// Textures of floats, brighter than white.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/area/area_integral.h"
#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "image_io/image_io.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/scene_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof::selftest {
namespace {

/// The noise as light of 2^-10 to 2^10, no two channels alike.
FilterFixture bright_noise() {
    FilterFixture fixture = filter_fixture(Ground::noise);
    Image& image = fixture.scene.images[0];
    for (std::size_t i = 0; i < image.texels.size(); i += 4) {
        const auto light = [&](std::size_t c) {
            return std::exp2(float(image.texels[i + c]) / 255.0f * 20.0f - 10.0f);
        };
        image.light.emplace_back(light(0), light(1), light(2), 1.0f);
    }
    return fixture;
}

Picture drawn(const FilterFixture& fixture, const char* method) {
    return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                {.method = *texture::find_method(method)});
}

/// Sums of large texels round coarser than those of codes.
TEST(TextureOfFloats, IsHeldToEveryDefinition) {
    const FilterFixture fixture = bright_noise();
    for (const texture::Method& method : texture::methods()) {
        const Picture picture = drawn(fixture, method.name.c_str());
        const ConformanceResult result = conformance_of(picture, fixture, method.name, {});
        EXPECT_FALSE(result.is_caught()) << method.name << ": " << in_words(result);
        EXPECT_NE(picture.at(60, 90).r, 0) << method.name;
    }
    for (const auto& [right, wrong] : {std::pair{"trilinear-gl", "brilinear"}, {"sat-affine", "sat-quad"}})
        EXPECT_GT(conformance_of(drawn(fixture, wrong), fixture, right, {}).found.outside, 1000u) << wrong;
}

/// Light of 1024 times the codes' permits 1024 times as much, sums in float32 included.
TEST(TextureOfFloats, PermitsAsMuchMoreAsItIsBrighter) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    const FilterClaim claim{.method = "bicubic", .precision = *preset_filter_precision("float32")};
    const auto width = [&](const Picture& picture) {
        return conformance_of(picture, fixture, claim).found.mean_width;
    };
    const double of_codes = width(drawn(fixture, "bicubic"));
    Image& image = fixture.scene.images[0];
    for (const glm::vec4& texel : texture::linear_image({image.width, image.height, image.texels}).texels)
        image.light.push_back(1024.0f * texel);
    EXPECT_NEAR(width(drawn(fixture, "bicubic")), 1024 * of_codes, 1e-6 * 1024 * of_codes);
}

/// Light of 5 everywhere has a mean of 5; its code would be that of white.
TEST(TextureOfFloats, HasItsOwnTruth) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    Image& image = fixture.scene.images[0];
    image.light.assign(image.texels.size() / 4, glm::vec4{5, 5, 5, 1});
    const auto truth = oracle::area_truth(fixture.scene, fixture.view, oracle::Reconstruction::nearest);
    const double factor = double{fixture.scene.materials[0].base_color_factor.g};
    EXPECT_NEAR(truth.mean.at(60, 90).g, 5 * factor, 1e-12);
}

TEST(TextureOfFloats, IsAsCertainAsItIsBright) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    fixture.scene.materials[0].base_color_factor = glm::vec4{1};
    const auto half_width = [&] {
        return oracle::area_truth(fixture.scene, fixture.view, oracle::Reconstruction::mitchell)
            .half_width.at(60, 90);
    };
    const double of_codes = half_width();
    Image& image = fixture.scene.images[0];
    image.light.assign(image.texels.size() / 4, glm::vec4{5, 5, 5, 1});
    EXPECT_GT(of_codes, 0);
    EXPECT_EQ(half_width(), 5 * of_codes);
}

TEST(TextureOfFloats, IsReadFromOpenExr) {
    const TestFolder folder;
    const std::filesystem::path file = folder.path() / "lamp.exr";
    Picture light{Resolution{2, 1}, LinearRgb{0.5f, 4, 0}};
    write_picture(file, light);
    EXPECT_TRUE(is_photograph(file) && is_photograph_of_floats(file));
    const Image image = photograph_scene(file, 16, 16).scene.images[0];
    ASSERT_EQ(image.light.size(), 2u);
    EXPECT_EQ(image.light[1], glm::vec4(0.5f, 4, 0, 1));
    EXPECT_EQ(image.texels, (std::vector<std::uint8_t>{188, 255, 0, 255, 188, 255, 0, 255}));
    light.at(1, 0).g = std::numeric_limits<float>::infinity();
    write_picture(file, light);
    EXPECT_THROW(photograph_scene(file, 16, 16), SceneError);
}

}  // namespace
}  // namespace zproof::selftest
