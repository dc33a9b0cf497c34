/// No method of the catalogue is outside of its own filter reference: on every ground, with every option that
/// matters.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "filters/methods/catalogue.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/selftest/filter_fault.h"
#include "filters/stored/mip_chain.h"
#include "math/interval_functions.h"

namespace zproof::selftest {
namespace {

struct Setting {
    const char* name;
    texture::FilterOptions options;
    texture::Derivatives derivatives = texture::Derivatives::analytic;
};

std::vector<Setting> settings() {
    return {{"default", {}},
            {"biased", {.lod_bias = 0.75, .lod_min = 1.25, .lod_max = 3.5}},
            {"box", {.mip_kernel = texture::MipKernel::box}},
            {"lanczos", {.mip_kernel = texture::MipKernel::lanczos3}},
            {"kaiser", {.mip_kernel = texture::MipKernel::kaiser3}},
            {"codes", {.decoding = texture::Decoding::after_filtering}},
            {"quad", {}, texture::Derivatives::quad_differences}};
}

class Clean : public testing::TestWithParam<Ground> {};

TEST_P(Clean, EveryMethodWithAReferenceConformsToIt) {
    const FilterFixture fixture = filter_fixture(GetParam());
    for (const texture::Method& method : texture::methods()) {
        if (oracle::find_filter_definition(method.name) == nullptr) continue;
        for (const Setting& setting : settings()) {
            const Picture picture = rasterizer::filtered(
                fixture.scene, fixture.view, fixture.frame,
                {.method = method, .options = setting.options, .derivatives = setting.derivatives});
            const ConformanceResult result =
                conformance_of(picture, fixture, method.name, setting.options, setting.derivatives);
            const Conformance& found = result.found;
            EXPECT_FALSE(result.chance && result.chance->is_outside())
                << method.name << ", " << setting.name << ": " << in_words(*result.chance);
            EXPECT_EQ(found.outside, 0u)
                << method.name << ", " << setting.name << ": slack " << found.worst_slack << " at ("
                << found.worst.x << ", " << found.worst.y << ")";
            EXPECT_GT(found.worst_slack, 0.1) << method.name << ": the question is not sharp";
            EXPECT_LT(found.mean_width, 1e-5) << method.name << ": the question is not sharp";
            if (std::getenv("ZPROOF_SHOW"))
                std::cout << method.name << ", " << setting.name << ": slack " << found.worst_slack
                          << ", width " << found.mean_width << ", undecided " << found.anything << "\n";
        }
    }
}

/// The mean of the draws lies within what the deterministic definition permits, but for the picture's
/// rounding.
TEST(StochasticDraws, HaveTheExpectationOfTheDeterministicMethod) {
    const FilterFixture fixture = filter_fixture(Ground::odd_sizes);
    for (const auto& [stochastic, deterministic] :
         {std::pair{"stochastic-bilinear", "bilinear"}, std::pair{"stochastic-trilinear", "trilinear-gl"}}) {
        const auto reference = [&](const char* name) {
            return oracle::FilterReference{fixture.scene, fixture.view, *oracle::find_filter_definition(name),
                                           reference_settings({}, {})};
        };
        const oracle::FilterReference draws = reference(stochastic), filtered = reference(deterministic);
        int pixels = 0;
        for (int y = 0; y < fixture.view.height; ++y)
            for (int x = 0; x < fixture.view.width; ++x) {
                const PrimitiveId id = fixture.frame.primitive.at(x, y);
                const auto drawn = draws.draws_at(x, y, id, {});
                if (!drawn) continue;
                glm::dvec3 mean{0};
                for (const ColourDraw& draw : drawn->draws)
                    mean += middle(draw.probability) * (draw.colour.low + draw.colour.high) / 2.0;
                const ColourRange expected = filtered.at(x, y, {&id, 1}, {}).front();
                EXPECT_TRUE(glm::all(glm::greaterThan(mean, expected.low - 0x1p-24)) &&
                            glm::all(glm::lessThan(mean, expected.high + 0x1p-24)))
                    << stochastic << " at (" << x << ", " << y << ")";
                ++pixels;
            }
        EXPECT_GT(pixels, 9000);
    }
}

/// Of several samples the range is wide, so that the tests by chance alone can tell.
TEST(StochasticDraws, OfSeveralSamplesConformForAnySeed) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    for (const char* name : {"stochastic-bilinear", "stochastic-trilinear"})
        for (const int samples : {4, 16})
            for (std::uint32_t seed = 0; seed < 4; ++seed) {
                const texture::FilterOptions options{.samples = samples, .seed = seed};
                const Picture picture =
                    rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                         {.method = *texture::find_method(name), .options = options});
                const ConformanceResult result = conformance_of(picture, fixture, name, options);
                EXPECT_FALSE(result.is_caught()) << name << ": " << in_words(result);
            }
}

/// Taps a 300th of the pixel beside their places on the picture: more than 9 bits, less than 8.
TEST(TapPlacement, OnThePictureIsHeldToItsBits) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const texture::Method shifted =
        distorted(*texture::find_method("aniso-ext"), [](Footprint f, const glm::dvec2&) {
            const bool is_across = glm::length(f.per_x) > glm::length(f.per_y);
            f.centre_raster += (is_across ? glm::dvec2{1, 0} : glm::dvec2{0, 1}) / 300.0;
            return f;
        });
    const Picture picture =
        rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, {.method = shifted});
    const auto outside = [&](double tap_bits) {
        return conformance_of(picture, fixture, {.method = "aniso-ext", .precision = {.tap_bits = tap_bits}})
            .found.outside;
    };
    EXPECT_EQ(outside(8), 0u);
    EXPECT_GT(outside(9), 0u);
}

/// A chain of the texels' codes instead of light: means of square roots, squared.
std::vector<texture::LinearImage> levels_averaged_as_codes(const Image& of) {
    texture::LinearImage image = texture::linear_image({of.width, of.height, of.texels});
    for (glm::vec4& texel : image.texels) texel = glm::sqrt(texel);
    std::vector<texture::LinearImage> levels = texture::mip_chain(image, texture::MipKernel::box, {});
    levels.erase(levels.begin());
    for (texture::LinearImage& level : levels)
        for (glm::vec4& texel : level.texels) texel *= texel;
    return levels;
}

/// Such a chain is right for a picture that promises it, wrong for one that promises zproof's own.
TEST(LevelsOfAUser, AreWhatAPictureIsHeldTo) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const texture::FilterOptions options{.given_levels =
                                             std::make_shared<const std::vector<texture::LinearImage>>(
                                                 levels_averaged_as_codes(fixture.scene.images.front()))};
    for (const char* name : {"trilinear-gl", "aniso-midpoint", "ewa-pbrt", "stochastic-interleaved"}) {
        const Picture picture =
            rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                 {.method = *texture::find_method(name), .options = options});
        EXPECT_FALSE(conformance_of(picture, fixture, name, options).is_caught()) << name;
        EXPECT_TRUE(conformance_of(picture, fixture, name, {}).is_caught()) << name;
    }
}

/// A parallel projection has no spread: its cones are as wide as a pixel everywhere.
TEST(RayCones, OfAParallelProjectionConform) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    Camera& camera = fixture.view.camera;
    camera.projection = Projection::parallel;
    camera.window = {-4, 4, -3.2, 3.2};
    camera.shear = {0.3, -0.2};
    camera.near_depth = -100;
    camera.far_depth = 1000;
    fixture.frame = oracle::exact_visibility(fixture.scene, fixture.view);
    EXPECT_GT(std::ranges::count_if(fixture.frame.primitive.pixels(),
                                    [](PrimitiveId id) { return id != PrimitiveId::none; }),
              1000);
    for (const char* name : {"trilinear-ray-cone", "aniso-ray-cone"}) {
        const Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                                     {.method = *texture::find_method(name)});
        const ConformanceResult result = conformance_of(picture, fixture, name, {});
        EXPECT_EQ(result.found.outside, 0u) << name << ": " << in_words(result);
        EXPECT_GT(result.found.worst_slack, 0.1) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Filters, Clean,
                         testing::Values(Ground::noise, Ground::odd_sizes, Ground::mirrored, Ground::turned));

}  // namespace
}  // namespace zproof::selftest
