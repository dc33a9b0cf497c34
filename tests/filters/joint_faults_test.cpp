/// Planted filter defects under the promise of graphics hardware: each is caught, by a pixel or over the
/// picture, or lies within the promise.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "filters/commands/joint_check.h"
#include "filters/methods/catalogue.h"
#include "rasterizer/texturing.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {

namespace selftest {
void PrintTo(const FilterFault& fault, std::ostream* out);  // faults_test.cpp
}

using selftest::FilterClaim;
using selftest::FilterFault;
using selftest::FilterFixture;

namespace {

/// What 8 bits of weights and of the LOD, coordinates of 22 bits and sums in float32 admit.
const std::map<std::string, std::string> within_promise{
    {"a_thousandth_of_a_texel", "a weight may be 2^-8 off, and so may a place"},
    {"place_in_256ths", "2^-9 of a texel at most"},
    {"coordinate_in_float32", "2^-24 of a coordinate, of which 2^-22 is promised"},
    {"lod_a_256th_off", "2^-8 of a level is promised"},
    {"nearest_instead_of_drawn",
     "its variance is 6.3 standard deviations off, and 7.6 are within chance here"},
    {"sat_in_float32", "sums of 24 bits are promised"}};

FilterFault small(const std::string& name, const std::string& method, const texture::Method& wrong) {
    return {.name = name,
            .sentence = "",
            .method = method,
            .inject = [wrong](const FilterFixture& fixture, const rasterizer::Texturing& right) {
                return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                            {.method = wrong, .options = right.options});
            }};
}

/// Errors that are small beside what a pixel may show, on the near ground.
std::vector<FilterFault> small_faults() {
    const auto trilinear = [](const std::string& name, const LimitedTrilinear& parts) {
        return small(name, "trilinear-gl", limited_trilinear(parts));
    };
    const auto ellipse = [](const std::string& name, const std::string& method, const LimitedEllipse& parts) {
        return small(name, method, limited_ellipse(parts));
    };
    // Ratios on the near ground stay below 16, the default limit.
    FilterFault unclamped = ellipse("ellipse_without_clamp", "ewa-pbrt", {.is_clamped = false});
    unclamped.options.max_anisotropy = 2;
    const Lattice eight{.bits = 8}, six{.bits = 6}, six_down{6, Rounding::down},
        seven_down{7, Rounding::down};
    return {trilinear("lod_bias_a_hundredth", {.lod = {.offset = 0.01}}),
            trilinear("lod_bias_minus_a_hundredth", {.lod = {.offset = -0.01}}),
            trilinear("lod_bias_a_fiftieth_and_8_bits",
                      {.lod = {8, Rounding::nearest, 0.02}, .weights = eight, .blend = eight}),
            trilinear("u_a_hundredth_of_a_texel", {.place_error = {0.01, 0}}),
            trilinear("v_a_hundredth_of_a_texel", {.place_error = {0, -0.01}}),
            trilinear("u_a_hundredth_and_8_bits",
                      {.lod = eight, .weights = eight, .blend = eight, .place_error = {0.01, 0}}),
            trilinear("weights_of_6_bits", {.weights = six, .blend = six}),
            trilinear("weights_of_6_bits_down", {.weights = six_down, .blend = six_down}),
            trilinear("weights_of_7_bits_down", {.weights = seven_down, .blend = seven_down}),
            trilinear("bilinear_weights_of_6_bits", {.weights = six}),
            trilinear("gain_a_hundredth", {.gain = 1.01}),
            unclamped,
            ellipse("ellipse_table_of_64", "ewa-pbrt", {.table_entries = 64}),
            ellipse("ellipse_table_of_64_for_128", "ewa-pbrt-table", {.table_entries = 64}),
            ellipse("ellipse_weights_of_5_bits", "ewa-pbrt", {.weights = {.bits = 5}})};
}

enum class Finder { pixel, picture, nobody };

Finder finder_of(const FilterFault& fault, const FilterFixture& fixture) {
    const FilterClaim claim{
        .method = fault.method, .options = fault.options, .precision = gpu_with_exact_lod()};
    const Picture picture =
        fault.inject(fixture, {.method = *texture::find_method(fault.method), .options = fault.options});
    const auto result = selftest::conformance_of(picture, fixture, claim);
    const JointConformance joint = joint_conformance_of(picture, fixture, claim);
    std::cout << fault.name << ": " << selftest::in_words(result) << "\n";
    for (const std::string& line : in_words(joint)) std::cout << "    " << line << "\n";
    if (result.is_caught()) return Finder::pixel;
    return joint.leaves_promise() ? Finder::picture : Finder::nobody;
}

class FaultUnderPromise : public testing::TestWithParam<FilterFault> {};

TEST_P(FaultUnderPromise, IsCaughtUnlessThePromiseAdmitsIt) {
    const Finder finder = finder_of(GetParam(), selftest::filter_fixture(GetParam().ground));
    const auto admitted = within_promise.find(GetParam().name);
    if (admitted == within_promise.end())
        EXPECT_NE(finder, Finder::nobody);
    else
        EXPECT_EQ(finder, Finder::nobody) << admitted->second;
}

INSTANTIATE_TEST_SUITE_P(Filters, FaultUnderPromise, testing::ValuesIn(selftest::filter_faults()),
                         [](const auto& fault) { return fault.param.name; });

class SmallFault : public testing::TestWithParam<FilterFault> {};

TEST_P(SmallFault, IsCaught) {
    static const FilterFixture ground = near_ground();
    EXPECT_NE(finder_of(GetParam(), ground), Finder::nobody);
}

INSTANTIATE_TEST_SUITE_P(Filters, SmallFault, testing::ValuesIn(small_faults()),
                         [](const auto& fault) { return fault.param.name; });

}  // namespace
}  // namespace zproof
