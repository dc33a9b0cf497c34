// Pictures of coins, whose mean and variance are known.
#include "filters/conformance/stochastic_conformance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace zproof {
namespace {

ColourDraw draw(double probability, double value) {
    return {Interval{probability}, {glm::dvec3{value}, glm::dvec3{value}}, {}};
}

/// White with the probability p, else black.
ColourDraws coin(double p, int samples = 1) { return {samples, {draw(p, 1), draw(1 - p, 0)}}; }

Picture tossed(double p, int samples, std::uint32_t seed) {
    std::mt19937 random{seed};
    Picture picture{Resolution{48, 32}};
    for (LinearRgb& pixel : picture.pixels()) {
        int white = 0;
        for (int i = 0; i < samples; ++i) white += double(random()) / 0x1p32 < p ? 1 : 0;
        const float value = float(white) / float(samples);
        pixel = {value, value, value};
    }
    return picture;
}

StochasticConformance judged(const Picture& picture, const ColourDraws& draws) {
    return stochastic_conformance(picture, [&](int, int) { return std::optional{draws}; });
}

const StochasticTest& test(const StochasticConformance& found, const std::string& name) {
    return *std::ranges::find(found.tests, name, &StochasticTest::name);
}

/// Two pixels of a coin of 1/4, one white and one black: they sum to 1/2 above the mean, of variance 2 *
/// 3/16. (v - 1/4)^2 is 9/16 and 1/16, 1/4 above 2 * 3/16; it takes 9/16 once in four: variance 2 (1/4 * 3/4)
/// (1/2)^2.
TEST(StochasticConformance, CountsInStandardDeviations) {
    Picture picture{Resolution{2, 1}};
    picture.at(0, 0) = {1, 1, 1};
    const StochasticConformance found = judged(picture, coin(0.25));
    EXPECT_EQ(found.pixels, 2u);
    EXPECT_NEAR(test(found, "mean, green").z, 0.5 / std::sqrt(2 * 3 / 16.0), 1e-9);
    EXPECT_NEAR(test(found, "variance, blue").z, 0.25 / std::sqrt(2 * 3 / 64.0), 1e-9);
    EXPECT_FALSE(found.is_outside());
}

/// Eighteen tests share the rate; a term of the mean is at most 3/4.
TEST(StochasticConformance, LimitIsBernsteins) {
    Picture picture{Resolution{2, 1}};
    picture.at(0, 0) = {1, 1, 1};
    const double t = test(judged(picture, coin(0.25)), "mean, red").limit * std::sqrt(2 * 3 / 16.0);
    const double probability = 2 * std::exp(-t * t / 2 / (2 * 3 / 16.0 + 0.75 * t / 3));
    EXPECT_NEAR(probability / (false_alarm_rate / 18), 1, 1e-6);
}

TEST(StochasticConformance, RightPicturesPassAndTheirDeviationsAreOfSizeOne) {
    for (const int samples : {1, 4}) {
        double squares = 0, of_variance = 0;
        constexpr int pictures = 300;
        for (std::uint32_t seed = 0; seed < pictures; ++seed) {
            const StochasticConformance found = judged(tossed(0.25, samples, seed), coin(0.25, samples));
            EXPECT_FALSE(found.is_outside()) << seed;
            squares += std::pow(test(found, "mean, red").z, 2) / pictures;
            of_variance += std::pow(test(found, "variance, red").z, 2) / pictures;
        }
        // Five standard deviations of the mean of 300 squares of standard normal numbers.
        const double by_chance = 5 * std::sqrt(2.0 / pictures);
        EXPECT_NEAR(squares, 1, by_chance) << samples;
        EXPECT_NEAR(of_variance, 1, by_chance) << samples;
    }
}

TEST(StochasticConformance, AnotherMeanOrVarianceIsOutside) {
    EXPECT_TRUE(test(judged(tossed(0.4, 1, 1), coin(0.25)), "mean, red").is_outside());
    Picture filtered{Resolution{48, 32}};
    for (LinearRgb& pixel : filtered.pixels()) pixel = {0.25f, 0.25f, 0.25f};
    const StochasticConformance found = judged(filtered, coin(0.25));
    EXPECT_FALSE(test(found, "mean, red").is_outside());
    EXPECT_TRUE(test(found, "variance, red").is_outside());
    EXPECT_LT(test(found, "variance, red").z, 0);
    EXPECT_EQ(found.worst().name.substr(0, 8), "variance");
    EXPECT_TRUE(test(judged(tossed(0.25, 1, 2), coin(0.25, 4)), "variance, red").is_outside());
    EXPECT_TRUE(test(judged(tossed(0.25, 4, 2), coin(0.25, 1)), "variance, red").is_outside());
}

/// A tilt that each pixel's own draws are weighted by finds what cancels in the sum: every other pixel is too
/// light, and the rest too dark.
TEST(StochasticConformance, TiltsFindWhatCancelsOverThePicture) {
    const Picture light = tossed(0.4, 1, 3), dark = tossed(0.1, 1, 4);
    Picture picture{light.size()};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) picture.at(x, y) = (x % 2 == 0 ? light : dark).at(x, y);
    const StochasticConformance found = stochastic_conformance(picture, [](int x, int) {
        ColourDraws draws = coin(0.25);
        draws.draws[0].tilt[1] = x % 2 == 0 ? 1 : -1;
        return std::optional{draws};
    });
    EXPECT_FALSE(test(found, "mean, red").is_outside());
    EXPECT_TRUE(test(found, "place along v, red").is_outside());
}

TEST(StochasticConformance, WhatIsCertainMustBeHit) {
    const ColourDraws certain{1, {draw(1, 0.5)}};
    Picture picture{Resolution{8, 8}};
    for (LinearRgb& pixel : picture.pixels()) pixel = {0.5f, 0.5f, 0.5f};
    EXPECT_FALSE(judged(picture, certain).is_outside());
    picture.at(3, 3).g = 0.6f;
    EXPECT_TRUE(judged(picture, certain).is_outside());
    picture.at(3, 3).g = NAN;
    EXPECT_TRUE(judged(picture, certain).is_outside());
}

/// A probability known to 1/8 permits a mean that is off by as much.
TEST(StochasticConformance, DeclaredPrecisionWidensTheExpectation) {
    const Picture picture = tossed(0.35, 1, 5);
    ColourDraws known = coin(0.25), vague = coin(0.25);
    vague.draws[0].probability = Interval{0.125, 0.375};
    vague.draws[1].probability = Interval{0.625, 0.875};
    EXPECT_TRUE(judged(picture, known).is_outside());
    EXPECT_FALSE(judged(picture, vague).is_outside());
}

}  // namespace
}  // namespace zproof
