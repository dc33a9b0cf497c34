#include "filters/study/published_results.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zproof::study {
namespace {

std::vector<PublishedFigure> figures_of(std::string_view name) {
    for (const PublishedResult& result : published_results())
        if (result.name == name) return result.figures();
    ADD_FAILURE() << name;
    return {};
}

TEST(PublishedResults, CrowsTableIsTheMeanItself) {
    const auto figures = figures_of("crow-1984");
    ASSERT_EQ(figures.size(), 3u);
    for (const PublishedFigure& figure : figures)
        EXPECT_NEAR(figure.ours, figure.published, 1e-4) << figure.what;
}

/// Sums of 256 x 256 texels grow to 2^15 or so; without their mean they stay near 2^9.
TEST(PublishedResults, AnOffsetGainsBitsOfASummedAreaTable) {
    const auto figures = figures_of("hensley-2005");
    ASSERT_EQ(figures.size(), 2u);
    for (const PublishedFigure& figure : figures) {
        EXPECT_GT(figure.ours, 25) << figure.what;
        EXPECT_LT(figure.ours, 45) << figure.what;
    }
}

TEST(PublishedResults, MomentsOverABoxBoundTheShareAboveALevel) {
    const auto figures = figures_of("lauritzen-2007");
    ASSERT_EQ(figures.size(), 2u);
    for (const PublishedFigure& figure : figures) EXPECT_LT(figure.ours, 1e-9) << figure.what;
}

TEST(PublishedResults, FourBilinearReadsAreABSplineOf16Taps) {
    EXPECT_LT(figures_of("sigg-hadwiger-2005").at(0).ours, 1e-6);
}

TEST(PublishedResults, MoreSamplesHaveLessVariance) {
    for (const PublishedFigure& figure : figures_of("stochastic-variance"))
        EXPECT_NEAR(figure.ours / figure.published, 1, 0.05) << figure.what;
}

TEST(PublishedResults, TheWorkedSetUpIsFoundToItsLastDigit) {
    const auto figures = figures_of("worked");
    ASSERT_EQ(figures.size(), 14u);
    for (const PublishedFigure& figure : figures)
        EXPECT_EQ(verdict_on(figure), "reproduced") << figure.what << " " << figure.ours;
}

TEST(PublishedResults, IdentitiesHoldAndOthersInputsClaimNothing) {
    for (const char* name : {"crow-1984", "lauritzen-2007", "sigg-hadwiger-2005", "stochastic-variance"})
        for (const PublishedFigure& figure : figures_of(name))
            EXPECT_EQ(verdict_on(figure), "holds") << figure.what;
    for (const PublishedFigure& figure : figures_of("hensley-2005"))
        EXPECT_EQ(verdict_on(figure), "other inputs") << figure.what;
}

std::string verdict_on(double ours, PublishedAs as) {
    return verdict_on(PublishedFigure{.what = "",
                                      .unit = "",
                                      .published = 4,
                                      .ours = ours,
                                      .decimals = 1,
                                      .as = as,
                                      .standard_error = 0.25});
}

TEST(Verdicts, AreOfHalfAUnitOfTheLastDecimalAndOfThreeStandardErrors) {
    EXPECT_EQ(verdict_on(4.0499, PublishedAs::measurement), "reproduced");
    EXPECT_EQ(verdict_on(4.0505, PublishedAs::measurement), "not reproduced");
    EXPECT_EQ(verdict_on(3.9501, PublishedAs::identity), "holds");
    EXPECT_EQ(verdict_on(3.9495, PublishedAs::identity), "does not hold");
    EXPECT_EQ(verdict_on(4.75, PublishedAs::expectation), "holds");
    EXPECT_EQ(verdict_on(3.2425, PublishedAs::expectation), "does not hold");
    EXPECT_EQ(verdict_on(std::nan(""), PublishedAs::identity), "does not hold");
    EXPECT_EQ(verdict_on(40, PublishedAs::measurement_elsewhere), "other inputs");
}

}  // namespace
}  // namespace zproof::study
