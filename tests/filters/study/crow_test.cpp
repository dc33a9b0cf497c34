#include "filters/study/crow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zproof::study {
namespace {

const CrowAnswers& answers() {
    static const CrowAnswers all = crow_answers();
    return all;
}

const CrowAnswer& by(const CrowQuestion& question, const std::string& method) {
    return *std::ranges::find(question.answers, method, &CrowAnswer::method);
}

/// A box of n texels has variance n^2 / 12 about its middle; texels as points lose 1/12 of that and, cut at a
/// fraction f of a texel, gain back f (1 - f) / n.
TEST(Crow, ExactKernelOfABox) {
    const Kernel whole = exact_kernel(64, {10.5, 20.5}, {5, 0}, {0, 3});
    EXPECT_NEAR(whole.sum, 1, 1e-14);
    EXPECT_NEAR(whole.deviation.x, std::sqrt(24 / 12.0), 1e-12);
    EXPECT_NEAR(whole.deviation.y, std::sqrt(8 / 12.0), 1e-12);
    EXPECT_NEAR(whole.weights[20 * 64 + 10], 1 / 15.0, 1e-15);
}

/// A diamond of diagonals 2 about a texel's corner: four texels, a quarter each.
TEST(Crow, ExactKernelOfATurnedSquare) {
    const Kernel diamond = exact_kernel(64, {8, 8}, {1, 1}, {-1, 1});
    for (const int texel : {7 * 64 + 7, 7 * 64 + 8, 8 * 64 + 7, 8 * 64 + 8})
        EXPECT_NEAR(diamond.weights[std::size_t(texel)], 0.25, 1e-15);
    EXPECT_NEAR(diamond.sum, 1, 1e-15);
}

TEST(Crow, ExactKernelAcrossTheEdgeOfTheTexture) {
    const Kernel kernel = exact_kernel(64, {0, 0}, {2, 0}, {0, 2});
    EXPECT_NEAR(kernel.weights[63 * 64 + 63], 0.25, 1e-15);
    EXPECT_NEAR(kernel.weights[0], 0.25, 1e-15);
    EXPECT_NEAR(kernel.sum, 1, 1e-15);
}

TEST(Crow, WeightsOfEveryAnswerSumToOne) {
    for (const CrowQuestion& question : answers().questions)
        for (const CrowAnswer& answer : question.answers)
            EXPECT_NEAR(answer.kernel.sum, 1, 1e-6) << question.region << " " << answer.method;
}

TEST(Crow, ASummedAreaTableAnswersAxisAlignedRegionsExactly) {
    EXPECT_LT(by(answers().questions[0], "sat-affine").rmse, 1e-6);
    EXPECT_LT(by(answers().questions[1], "sat-affine").rmse, 1e-6);
    EXPECT_GT(by(answers().questions[2], "sat-affine").rmse, 1e-2);
}

TEST(Crow, AMipMapBlursWhatIsNotSquare) {
    const CrowQuestion& oblong = answers().questions[1];
    const glm::dvec2 exact = by(oblong, "exact").kernel.deviation,
                     mip = by(oblong, "trilinear-gl").kernel.deviation;
    EXPECT_GT(mip.y, 4 * exact.y);
    EXPECT_GT(by(oblong, "trilinear-gl").rmse, by(oblong, "ripmap").rmse);
}

TEST(Crow, FractionsBetweenLevels) {
    const auto five = std::ranges::find(answers().levels, 5.0, &BetweenLevels::side);
    EXPECT_EQ(five->level, 2);
    EXPECT_NEAR(five->by_logarithm, 0.32192809488736235, 1e-15);
    EXPECT_EQ(five->by_width, 0.25);
}

}  // namespace
}  // namespace zproof::study
