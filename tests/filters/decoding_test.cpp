/// Where sRGB codes are made light: before they are filtered, or after.
#include <gtest/gtest.h>

#include "filters/selftest/filter_fault.h"

namespace zproof::selftest {
namespace {

/// A filter of all texels alike.
texture::Method mean_of_all() {
    return {.name = "mean", .card = {}, .prepare = [](const texture::LinearImage& image, const auto&) {
                glm::dvec4 mean{0};
                for (const glm::vec4& texel : image.texels) mean += glm::dvec4{texel};
                mean /= double(image.texels.size());
                return texture::Sampler{
                    .colour = [mean](const Footprint&) { return mean; }, .taps = {}, .stored = {}};
            }};
}

/// Black and white in equal shares: light of 1/2, or a code of 1/2, ((0.5 + 0.055) / 1.055)^2.4 = 0.214041 of
/// light.
TEST(Decoding, OfAMeanOfCodesIsDarkerThanTheMeanOfLight) {
    FilterFixture fixture = filter_fixture(Ground::noise);
    fixture.scene.materials[0].base_color_factor = glm::vec4{1};
    std::vector<std::uint8_t>& texels = fixture.scene.images[0].texels;
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = i % 8 < 4 ? 0 : 255;
    const auto shown = [&](texture::Decoding decoding) {
        const Picture picture =
            rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                 {.method = mean_of_all(), .options = {.decoding = decoding}});
        return picture.at(60, 90).g;
    };
    EXPECT_EQ(shown(texture::Decoding::before_filtering), 0.5f);
    EXPECT_NEAR(shown(texture::Decoding::after_filtering), 0.214041140, 1e-7);
}

}  // namespace
}  // namespace zproof::selftest
