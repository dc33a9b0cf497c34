/// A rule at fault is named only where it alone explains what is wrong.
#include <gtest/gtest.h>

#include "cli/selftest/filter_fault.h"
#include "tests/filters/limited_sampler.h"
#include "texture/catalogue.h"

namespace zproof {
namespace {

RuleRelaxation explains(FilterRule rule, double share) {
    return {.rule = rule, .bits = 3, .explained = share};
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

TEST(RuleTold, IsNotThatWeightsMayBeAnyMean) {
    RuleRelaxation weights = explains(FilterRule::weights, 1);
    EXPECT_TRUE(rule_told({weights, explains(FilterRule::sums, 1)}));
    weights.bits = 1;
    EXPECT_FALSE(rule_told({weights, explains(FilterRule::sums, 1)}));
}

std::optional<RuleRelaxation> told_under_gpu(const Picture& picture, const selftest::FilterFixture& fixture,
                                             const std::string& method) {
    return rule_told(
        selftest::conformance_of(picture, fixture, {.method = method, .precision = gpu_with_exact_lod()})
            .rules);
}

/// A level of other texels, and a factor that is not there, are no matter of weights.
TEST(RuleTold, IsNotWeightsWhereTexelsOrTheFactorAreWrong) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    for (const selftest::FilterFault& fault : selftest::filter_faults()) {
        if (fault.name != "lanczos_for_box" && fault.name != "factor_ignored") continue;
        const Picture picture =
            fault.inject(fixture, {.method = *texture::find_method(fault.method), .options = fault.options});
        EXPECT_FALSE(told_under_gpu(picture, fixture, fault.method)) << fault.name;
    }
}

/// Of a 2 x 2 read and of the blend of two levels: neither a place nor an LOD explains both.
TEST(RuleTold, IsWeightsWhereTheyHaveTooFewBits) {
    const selftest::FilterFixture fixture = selftest::filter_fixture(selftest::Ground::noise);
    const Lattice quarters{.bits = 2};
    const Picture picture =
        rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                             {.method = limited_trilinear({.weights = quarters, .blend = quarters})});
    const auto told = told_under_gpu(picture, fixture, "trilinear-gl");
    ASSERT_TRUE(told);
    EXPECT_EQ(told->rule, FilterRule::weights);
    EXPECT_EQ(told->bits, 3) << "a quarter rounded is off by an eighth";
}

TEST(RuleTold, IsSaidInWords) {
    selftest::ConformanceResult result;
    result.found.outside = 3, result.found.judged = 9, result.found.worst_slack = 2;
    result.rules = {explains(FilterRule::lod, 1)};
    EXPECT_EQ(selftest::in_words(result), "3 of 9 pixels outside, slack 2; at fault: LOD, to 3 bits");
    result.rules.push_back(explains(FilterRule::weights, 1));
    EXPECT_EQ(selftest::in_words(result), "3 of 9 pixels outside, slack 2; rule at fault: not told");
}

}  // namespace
}  // namespace zproof
