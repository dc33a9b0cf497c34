/// No method of the catalogue is outside of its own filter reference: on every ground, with every option that
/// matters.
#include <gtest/gtest.h>

#include <iostream>

#include "cli/selftest/filter_fault.h"
#include "cli/selftest/filter_variants.h"
#include "texture/catalogue.h"

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
            const Conformance found =
                conformance_of(picture, fixture, method.name, setting.options, setting.derivatives).found;
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

INSTANTIATE_TEST_SUITE_P(Filters, Clean,
                         testing::Values(Ground::noise, Ground::odd_sizes, Ground::mirrored, Ground::turned));

}  // namespace
}  // namespace zproof::selftest
