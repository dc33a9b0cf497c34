/// A rule at fault is named only where it alone explains what is wrong.
#include <gtest/gtest.h>

#include "cli/selftest/filter_fault.h"

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
