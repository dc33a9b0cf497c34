/// Pictures of 8-bit sRGB codes, and what a promise of them permits.
#include "filters/conformance/picture_format.h"

#include <gtest/gtest.h>

#include "filters/commands/check_power.h"
#include "filters/commands/joint_check.h"
#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "math/srgb.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

using selftest::FilterClaim;
using selftest::FilterFixture;

float light_of(int code) { return float(decoded_srgb(code / 255.0)); }

FilterClaim claim_of_codes(const char* method) {
    FilterPrecision promise = *preset_filter_precision("float32");
    promise.code_error = 0.5;
    return {.method = method, .precision = promise};
}

/// Light of 1/2 has code 187.516.
TEST(PictureFormat, CodesAreTheNearest) {
    Picture picture{Resolution{1, 1}};
    picture.at(0, 0) = {0.5f, 0, 1};
    EXPECT_EQ(as_stored(picture, {}).at(0, 0).r, 0.5f);
    const LinearRgb stored = as_stored(picture, {.code_error = 0.5}).at(0, 0);
    EXPECT_EQ(stored.r, light_of(188));
    EXPECT_EQ(stored.g, 0);
    EXPECT_EQ(stored.b, 1);
}

/// Half of the light of code 128 has code 92.37353: code 92 lies 0.37353 beside its place, code 93 0.62647.
TEST(PictureFormat, ACodeMayLieSoFarBesideItsPlaceAndNoFarther) {
    FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    for (std::uint8_t& texel : fixture.scene.images[0].texels) texel = 128;
    fixture.scene.materials[0].base_color_factor = glm::vec4{0.5f};
    const auto outside = [&](int code, double code_error) {
        Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                               {.method = *texture::find_method("nearest"), .options = {}});
        for (LinearRgb& pixel : picture.pixels())
            if (pixel.r > 0) pixel = {light_of(code), light_of(code), light_of(code)};
        const FilterClaim claim{.method = "nearest", .precision = {.code_error = code_error}};
        return selftest::conformance_of(picture, fixture, claim).found.outside;
    };
    EXPECT_EQ(outside(92, 0.374), 0u);
    EXPECT_GT(outside(92, 0.373), 0u);
    EXPECT_EQ(outside(93, 0.627), 0u);
    EXPECT_GT(outside(93, 0.626), 0u);
}

TEST(PictureFormat, ARightPictureOfCodesPassesAsAWhole) {
    const FilterFixture fixture = near_ground();
    const FilterClaim claim = claim_of_codes("trilinear-gl");
    const Picture right = selftest::picture_under({}, fixture, claim);
    const Conformance found = selftest::conformance_of(right, fixture, claim).found;
    EXPECT_EQ(found.outside, 0u);
    const JointCheck joint = joint_check_of(fixture, claim);
    EXPECT_FALSE(joint.judge(right).leaves_promise());
    EXPECT_TRUE(power_of(fixture, claim, found, joint).proves_something());
    const FilterClaim of_light{.method = "trilinear-gl", .precision = *preset_filter_precision("float32")};
    EXPECT_GT(selftest::conformance_of(right, fixture, of_light).found.outside, 0u);
}

TEST(PictureFormat, OneCodeTooManyIsSeen) {
    const FilterFixture fixture = near_ground();
    const FilterClaim claim = claim_of_codes("bilinear");
    Picture picture = selftest::picture_under({}, fixture, claim);
    float& green = picture.at(100, 200).g;
    const int code = int(std::lround(255 * encoded_srgb(double{green})));
    green = light_of(code < 255 ? code + 1 : code - 1);
    const Conformance found = selftest::conformance_of(picture, fixture, claim).found;
    EXPECT_EQ(found.outside, 1u);
    EXPECT_EQ(found.worst, (FilterPixel{100, 200}));
}

}  // namespace
}  // namespace zproof
