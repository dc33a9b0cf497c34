#include "filters/study/claims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zproof::study {
namespace {

/// A study of one region and one metric: methods with these RMSEs, a truth known to half_width.
StudyResults study_of(const std::vector<double>& rmse, double half_width, std::uint64_t pixels = 10) {
    StudyResults results;
    results.metrics = {{.name = "psnr", .definition = {}, .source = {}},
                       {.name = "rmse", .definition = {}, .source = {}}};
    results.views.emplace_back();
    for (std::size_t i = 0; i < rmse.size(); ++i)
        results.views[0].methods.push_back({.label = std::string(1, char('a' + i)),
                                            .regions = {{"interior", pixels, half_width, {0, rmse[i]}}},
                                            .cost = {},
                                            .flicker = {},
                                            .file = {}});
    return results;
}

std::vector<int> places(const StudyResults& results) { return ranks(results, results.views[0], "interior"); }

TEST(Claims, ADifferenceNeedsATruthKnownToAFifthOfIt) {
    const RegionScore score{"interior", 10, 0.02, {}};
    EXPECT_TRUE(may_claim(score, 0.1));
    EXPECT_TRUE(may_claim(score, -0.1));
    EXPECT_FALSE(may_claim(score, 0.0999));
    EXPECT_TRUE(may_claim({"interior", 10, 0, {}}, 1e-12));
}

TEST(Claims, AMethodsOwnErrorIsAClaimAsWell) {
    const StudyResults results = study_of({0.5, 0.09}, 0.02);
    EXPECT_TRUE(is_resolved(results, results.views[0].methods[0].regions[0]));
    EXPECT_FALSE(is_resolved(results, results.views[0].methods[1].regions[0]));
}

TEST(Claims, RanksFollowTheError) { EXPECT_EQ(places(study_of({0.3, 0.1, 0.2}, 0)), (std::vector{3, 1, 2})); }

TEST(Claims, MethodsThatCannotBeToldApartShareARank) {
    EXPECT_EQ(places(study_of({0.30, 0.10, 0.15, 0.60}, 0.02)), (std::vector{3, 1, 1, 4}));
    EXPECT_EQ(places(study_of({0.2, 0.2, 0.1}, 0)), (std::vector{2, 2, 1}));
}

TEST(Claims, WhatIsNoNumberComesLast) {
    EXPECT_EQ(places(study_of({std::nan(""), 0.1}, 0)), (std::vector{2, 1}));
}

TEST(Claims, AnEmptyRegionRanksNobody) {
    EXPECT_EQ(places(study_of({0.1, 0.2}, 0, 0)), (std::vector{0, 0}));
    const StudyResults results = study_of({0.1}, 0);
    EXPECT_EQ(ranks(results, results.views[0], "no such region"), std::vector{0});
    EXPECT_TRUE(std::isnan(value_of(results, results.views[0].methods[0], "interior", "no such metric")));
    EXPECT_EQ(value_of(results, results.views[0].methods[0], "interior", "rmse"), 0.1);
}

}  // namespace
}  // namespace zproof::study
