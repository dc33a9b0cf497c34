/// A material's factor is a number of a JSON file: a renderer may read it as a double or as a float32.
#include <gtest/gtest.h>

#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"

namespace zproof::selftest {
namespace {

constexpr glm::dvec4 in_the_file{0.1, 0.3, 0.7, 1};

FilterFixture with_factor(const glm::vec4& factor) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    fixture.scene.materials[0].base_color_factor = factor;
    return fixture;
}

FilterFixture read_from_file() {
    FilterFixture fixture = with_factor(glm::vec4{in_the_file});
    fixture.scene.materials[0].base_color_factor_rounding = in_the_file - glm::dvec4{glm::vec4{in_the_file}};
    return fixture;
}

Picture drawn(const FilterFixture& fixture) {
    return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                {.method = *texture::find_method("bilinear")});
}

/// The texture alone in float32 would round twice: each tap's sum times the double, as a renderer of doubles
/// has it.
Picture drawn_in_double() {
    const texture::Method scaled = [] {
        texture::Method method = *texture::find_method("bilinear");
        const auto prepare = method.prepare;
        method.prepare = [prepare](const texture::LinearImage& image, const texture::FilterOptions& options) {
            texture::Sampler sampler = prepare(image, options);
            sampler.colours = {};
            sampler.colour = [colour = sampler.colour](const texture::Footprint& f) {
                return in_the_file * colour(f);
            };
            return sampler;
        };
        return method;
    }();
    const FilterFixture white = with_factor(glm::vec4{1});
    return rasterizer::filtered(white.scene, white.view, white.frame, {.method = scaled});
}

TEST(Factor, BothReadingsAreAdmissible) {
    const FilterFixture fixture = read_from_file();
    EXPECT_EQ(conformance_of(drawn(fixture), fixture, "bilinear", {}).found.outside, 0u);
    EXPECT_EQ(conformance_of(drawn_in_double(), fixture, "bilinear", {}).found.outside, 0u);
}

TEST(Factor, NothingBeyondThemIs) {
    const FilterFixture exact = with_factor(glm::vec4{in_the_file});
    EXPECT_GT(conformance_of(drawn_in_double(), exact, "bilinear", {}).found.outside, 0u);
    const FilterFixture fixture = read_from_file();
    glm::vec4 next{in_the_file};
    for (int steps = 0; steps < 4; ++steps) next.r = std::nextafter(next.r, 0.0f);
    EXPECT_GT(conformance_of(drawn(with_factor(next)), fixture, "bilinear", {}).found.outside, 0u);
}

}  // namespace
}  // namespace zproof::selftest
