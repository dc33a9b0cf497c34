/// A rule at fault is named only where it alone explains what is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "tests/filters/limited_sampler.h"

namespace zproof {
namespace {

RuleRelaxation explains(FilterRule rule, double share) {
    return {.rule = rule, .bits = 3, .explained = share, .permissive = rule == FilterRule::sums ? 0.5 : 0.25};
}

TEST(RuleTold, IsTheOnlyOneThatExplainsEveryPixel) {
    const auto told = rule_told(
        {explains(FilterRule::lod, 1), explains(FilterRule::weights, 0.999), explains(FilterRule::sums, 1)});
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::lod);
}

TEST(RuleTold, IsNoneWhereSeveralExplainThem) {
    EXPECT_FALSE(rule_told({explains(FilterRule::lod, 1), explains(FilterRule::weights, 1)}));
    EXPECT_FALSE(rule_told(
        {explains(FilterRule::lod, 1), explains(FilterRule::sums, 1), explains(FilterRule::coordinates, 1)}));
}

TEST(RuleTold, IsSumsOnlyWhereNoOtherExplainsThem) {
    const auto told = rule_told({explains(FilterRule::lod, 0.5), explains(FilterRule::sums, 1)});
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::sums);
    EXPECT_FALSE(rule_told({explains(FilterRule::lod, 0.5)}));
    EXPECT_FALSE(rule_told({}));
}

TEST(RuleTold, IsNoneThatPermitsAsMuchAsAnyError) {
    RuleRelaxation coordinates = explains(FilterRule::coordinates, 1);
    EXPECT_TRUE(rule_told({coordinates, explains(FilterRule::sums, 1)}));
    coordinates.permissive = 0.5;
    EXPECT_FALSE(rule_told({coordinates, explains(FilterRule::sums, 1)}));
    coordinates.permissive = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(rule_told({coordinates}));
}

TEST(RuleTold, IsNotThatWeightsMayBeAnyMean) {
    RuleRelaxation weights = explains(FilterRule::weights, 1);
    EXPECT_TRUE(rule_told({weights, explains(FilterRule::sums, 1)}));
    weights.bits = 1;
    EXPECT_FALSE(rule_told({weights, explains(FilterRule::sums, 1)}));
}

std::optional<RuleRelaxation> told_under_gpu(const Picture& picture, const selftest::FilterFixture& fixture,
                                             const std::string& method,
                                             const FilterPrecision& promise = gpu_with_exact_lod()) {
    return rule_told(
        selftest::conformance_of(picture, fixture, {.method = method, .precision = promise}).rules);
}

/// What is told under gpu of a planted defect.
std::optional<RuleRelaxation> told_of(const std::string& name, const selftest::FilterFixture& fixture) {
    const std::vector<selftest::FilterFault> all = selftest::filter_faults();
    const auto fault = std::ranges::find(all, name, &selftest::FilterFault::name);
    const Picture picture =
        fault->inject(fixture, {.method = *texture::find_method(fault->method), .options = fault->options});
    return told_under_gpu(picture, fixture, fault->method);
}

/// A level of other texels is no matter of weights.
TEST(RuleTold, IsNotWeightsWhereTexelsAreWrong) {
    EXPECT_FALSE(told_of("lanczos_for_box", selftest::filter_fixture(selftest::Ground::noise)));
}

/// What is told of a planted defect under the promise of double arithmetic.
std::optional<RuleRelaxation> told_in_doubles(const std::string& name,
                                              const selftest::FilterFixture& fixture) {
    const std::vector<selftest::FilterFault> all = selftest::filter_faults();
    const auto fault = std::ranges::find(all, name, &selftest::FilterFault::name);
    return rule_told(selftest::try_filter_fault(*fault, fixture).rules);
}

/// A window's ends bound any error of a summed area, so their place is not told apart from anything.
TEST(RuleTold, IsNotCoordinatesWhereTheyBoundAnyError) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    EXPECT_FALSE(told_in_doubles("triangle_for_quadratic", fixture));
    const auto told = told_in_doubles("half_texel_right", fixture);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::coordinates);
}

TEST(RuleTold, IsTheFactorWhereOneHoldsAtEveryPixel) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    const auto told = told_in_doubles("factor_ignored", fixture);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::factor);
    const glm::vec4 factor = fixture.scene.materials.at(0).base_color_factor;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(told->times[c] * double(factor[c]), 1, 1e-6) << c;
}

/// Twice the value at one pixel alone is no factor: the others contradict it.
TEST(RuleTold, IsNotTheFactorOfOneWrongPixel) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                           {.method = *texture::find_method("bilinear")});
    LinearRgb& wrong = picture.at(60, 60);
    wrong = {2 * wrong.r, 2 * wrong.g, 2 * wrong.b};
    const auto told = told_under_gpu(picture, fixture, "bilinear");
    EXPECT_FALSE(told && told->rule == FilterRule::factor);
}

/// Of a 2 x 2 read and of the blend of two levels: neither a place nor an LOD explains both. Splits are
/// exact, as the sampler's are: with the nine bits of gpu a place that is two texels off explains both, too.
TEST(RuleTold, IsWeightsWhereTheyHaveTooFewBits) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    const Lattice quarters{.bits = 2};
    const Picture picture =
        rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                             {.method = limited_trilinear({.weights = quarters, .blend = quarters})});
    FilterPrecision promise = gpu_with_exact_lod();
    promise.split_bits = FilterPrecision::exact;
    const auto told = told_under_gpu(picture, fixture, "trilinear-gl", promise);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::weights);
    EXPECT_EQ(told->bits, 3) << "a quarter rounded is off by an eighth";
}

/// Nor the factor of a picture with a value that is no number, or with light where none is permitted.
TEST(RuleTold, IsNotTheFactorWhereAPixelHasNone) {
    const PixelReference black = [](int, int, const FilterPrecision&) {
        return PermittedColours{{glm::dvec3{0}, glm::dvec3{0x1p-149}}};
    };
    const PixelReference about_zero = [](int x, int, const FilterPrecision&) {
        return x == 0 ? PermittedColours{{glm::dvec3{-0.5}, glm::dvec3{0.5}}}
                      : PermittedColours{{glm::dvec3{1}, glm::dvec3{1}}};
    };
    const float endless = std::numeric_limits<float>::infinity();
    const auto told = [](const Picture& picture, const PixelReference& reference) {
        const auto rule =
            rule_told(rules_at_fault(picture, conformance(picture, reference, {}), reference, {}));
        return rule && rule->rule == FilterRule::factor;
    };
    const Resolution size{2, 1};
    EXPECT_FALSE(told(Picture(size, LinearRgb{0.5f, 0.5f, 0.5f}), black));
    EXPECT_FALSE(told(Picture(size, LinearRgb{endless, endless, endless}), about_zero));
    Picture twice(size, LinearRgb{2, 2, 2});
    twice.at(0, 0) = {-0.9f, -0.9f, -0.9f};
    EXPECT_TRUE(told(twice, about_zero));
    twice.at(0, 0) = {-1.1f, -1.1f, -1.1f};
    EXPECT_FALSE(told(twice, about_zero)) << "below what twice the range holds";
}

TEST(RuleTold, IsSaidInWords) {
    selftest::ConformanceResult result;
    result.found.outside = 3, result.found.judged = 9, result.found.worst_slack = 2;
    result.rules = {explains(FilterRule::lod, 1)};
    EXPECT_EQ(selftest::in_words(result), "3 of 9 pixels outside, slack 2; at fault: LOD, to 3 bits");
    RuleRelaxation factor = explains(FilterRule::factor, 1);
    factor.times = {2, 1, 0.5};
    result.rules = {factor, explains(FilterRule::lod, 1)};
    EXPECT_EQ(selftest::in_words(result),
              "3 of 9 pixels outside, slack 2; at fault: factor, times 2, 1, 0.5");
    result.rules = {explains(FilterRule::lod, 1), explains(FilterRule::weights, 1)};
    EXPECT_EQ(selftest::in_words(result), "3 of 9 pixels outside, slack 2; rule at fault: not told");
}

}  // namespace
}  // namespace zproof
