/// A cause is named where the picture is that of the definition with one thing changed, and no other is.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "filters/selftest/likely_cause.h"
#include "math/srgb.h"

namespace zproof::selftest {

void PrintTo(const FilterFault& fault, std::ostream* out);  // faults_test.cpp

namespace {

std::vector<std::string> causes(const Picture& picture, const FilterFixture& fixture,
                                const FilterClaim& claim) {
    const ConformanceResult result = conformance_of(picture, fixture, claim);
    return causes_of(picture, ChangedDefinitions{fixture, claim}, claim, result.found,
                     likely_changes(fixture.scene, claim));
}

/// What is named of the planted defects, under the exact promise.
const std::map<std::string, std::string> named{
    {"half_texel_right", "places half a texel along u"},
    {"half_texel_nearest", "places half a texel along u and v"},
    {"v_flipped", "v runs upwards"},
    {"clamp_for_repeat", "wraps are clamp along u and repeat along v"},
    {"transform_ignored", "the texture's transform is ignored"},
    {"wrapped_derivative", "coordinates are wrapped before they are differenced across the pixel"},
    {"differences_for_derivatives", "steps are differences within 2 x 2 pixels"},
    {"lod_one_too_large", "LOD a level too high"},
    {"lod_one_too_small", "LOD a level too low"},
    {"area_for_the_longer_step", "it is trilinear-area"},
    {"last_level_missing", "no level above 6"},
    {"trilinear_without_blend", "it is mip-nearest-bilinear"},
    {"catmull_rom_for_bilinear", "it is bicubic"},
    {"linear_taps", "it is aniso-ext-linear"},
    {"anisotropy_not_limited", "the limit of anisotropy is 64"},
    {"one_tap", "the limit of anisotropy is 1"},
    {"lanczos_for_box", "levels by lanczos3"},
    {"lanczos_for_kaiser", "levels by lanczos3"},
    {"blend_in_half_of_each_octave", "it is brilinear"},
    {"blend_in_every_octave", "it is trilinear-gl"},
    {"codes_filtered", "sRGB is decoded after filtering"},
    {"last_column_dropped", "levels by box"}};

class CauseOfFault : public testing::TestWithParam<FilterFault> {};

TEST_P(CauseOfFault, IsNamed) {
    const FilterFault& fault = GetParam();
    const FilterFixture fixture = filter_fixture(fault.ground);
    const Picture picture =
        fault.inject(fixture, {.method = *texture::find_method(fault.method), .options = fault.options});
    const FilterClaim claim{.method = fault.method, .options = fault.options};
    const std::vector<std::string> found = causes(picture, fixture, claim);
    std::cout << fault.name << ": " << testing::PrintToString(found) << "\n";
    EXPECT_TRUE(std::ranges::find(found, named.at(fault.name)) != found.end());
}

std::vector<FilterFault> faults_with_a_cause() {
    std::vector<FilterFault> all = filter_faults();
    std::erase_if(all, [](const FilterFault& fault) { return !named.contains(fault.name); });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Filters, CauseOfFault, testing::ValuesIn(faults_with_a_cause()),
                         [](const auto& fault) { return fault.param.name; });

/// A picture of the method with a change that only its reference knows: what that permits, in the middle.
Picture middles(const FilterFixture& fixture, const FilterClaim& claim, const DefinitionChange& change) {
    const PixelReference reference = ChangedDefinitions{fixture, claim}.under(change);
    Picture picture{Resolution{fixture.view.width, fixture.view.height}};
    for (int y = 0; y < fixture.view.height; ++y)
        for (int x = 0; x < fixture.view.width; ++x) {
            const ColourRange range = reference(x, y, claim_under(change, claim).precision).front();
            const glm::dvec3 middle =
                std::isinf(range.low.x) ? glm::dvec3{0} : (range.low + range.high) / 2.0;
            picture.at(x, y) = {float(middle.r), float(middle.g), float(middle.b)};
        }
    return picture;
}

TEST(LikelyCause, IsNamedOfWhatNoMethodCanBeSetTo) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    for (const auto& [method, name] :
         {std::pair{"trilinear-gl", "sRGB is decoded after filtering"},
          {"bilinear", "sRGB is not decoded"},
          {"aniso-midpoint", "one tap too many"},
          {"trilinear-gl", "places half a texel of each level along u and v"},
          {"trilinear-gl", "coordinates are wrapped before they are differenced within 2 x 2 pixels"},
          {"trilinear-gl", "reads do not cross the texture's seams"},
          {"bilinear", "pixels are seen through their upper left corners"},
          {"sat-affine", "boxes end a column too late"},
          {"sat-quad", "boxes end a row too early"},
          {"sat-affine", "places a texel along u"}}) {
        const FilterClaim claim{.method = method};
        const auto changes = likely_changes(fixture.scene, claim);
        const auto change = std::ranges::find(changes, name, &DefinitionChange::name);
        ASSERT_NE(change, changes.end()) << name;
        const auto found = causes(middles(fixture, claim, *change), fixture, claim);
        EXPECT_TRUE(std::ranges::find(found, name) != found.end())
            << method << ": " << name << ": " << testing::PrintToString(found);
    }
}

/// The right picture after `change`, of which alone the cause of that name tells.
void expect_named(const std::string& name,
                  const std::function<LinearRgb(const Picture& right, int x, int y)>& change) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    for (const char* promise : {"float64", "gpu"}) {
        const FilterClaim claim{.method = "aniso-d3d11", .precision = *preset_filter_precision(promise)};
        const Picture right = picture_under({}, fixture, claim);
        Picture wrong = right;
        for (int y = 0; y < right.size().height; ++y)
            for (int x = 0; x < right.size().width; ++x) wrong.at(x, y) = change(right, x, y);
        EXPECT_EQ(causes(wrong, fixture, claim), std::vector{name}) << promise;
    }
}

TEST(LikelyCause, IsNamedWhereTheRightPictureWasSpoiled) {
    expect_named("the picture is upside down",
                 [](const Picture& right, int x, int y) { return right.at(x, right.size().height - 1 - y); });
    expect_named("the picture lies a pixel to the right",
                 [](const Picture& right, int x, int y) { return right.at(std::max(x - 1, 0), y); });
    expect_named("red and blue are exchanged", [](const Picture& right, int x, int y) {
        const LinearRgb c = right.at(x, y);
        return LinearRgb{c.b, c.g, c.r};
    });
    expect_named("values are sRGB codes", [](const Picture& right, int x, int y) {
        const LinearRgb c = right.at(x, y);
        return LinearRgb{float(encoded_srgb(double{c.r})), float(encoded_srgb(double{c.g})),
                         float(encoded_srgb(double{c.b}))};
    });
}

TEST(LikelyCause, IsNoneOfARightPictureNorOfOneThatIsWrongInTwoWays) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const FilterClaim claim{.method = "trilinear-gl"};
    Picture picture = picture_under({}, fixture, claim);
    EXPECT_TRUE(causes(picture, fixture, claim).empty());
    FilterClaim other = claim;
    other.options.lod_bias = 1, other.derivatives = texture::Derivatives::quad_differences;
    EXPECT_TRUE(causes(picture_under({}, fixture, other), fixture, claim).empty());
}

}  // namespace
}  // namespace zproof::selftest
