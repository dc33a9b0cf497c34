// Metrics against values worked by hand from their definitions, and against what must hold of them.
#include "filters/metrics/picture_metric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace zproof {
namespace {

LinearPicture flat(Resolution size, const glm::dvec3& colour) { return LinearPicture(size, colour); }

LinearPicture noise(Resolution size, std::uint32_t seed) {
    std::mt19937 random{seed};
    LinearPicture picture(size);
    for (glm::dvec3& p : picture.pixels())
        for (int c = 0; c < 3; ++c) p[c] = double(random()) * 0x1p-32;
    return picture;
}

double value(const char* name, const LinearPicture& candidate, const LinearPicture& truth) {
    const PictureMetric& metric = *find_picture_metric(name);
    return measured(metric, metric.map(candidate, truth), Plane<std::uint8_t>(truth.size(), 1));
}

constexpr Resolution one{1, 1}, two{2, 1}, small{23, 17};

TEST(PictureMetrics, HaveNamesOfTheirOwnAndADefinition) {
    std::set<std::string_view> names;
    for (const PictureMetric& metric : picture_metrics(LightRange::beyond_white)) {
        EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
        EXPECT_FALSE(metric.definition.empty()) << metric.name;
    }
    EXPECT_EQ(find_picture_metric("no such metric"), nullptr);
    EXPECT_EQ(picture_metrics().size() + 2, names.size());
}

TEST(PictureMetrics, OfAPictureAndItself) {
    const LinearPicture picture = noise(small, 1);
    for (const char* name :
         {"rmse", "mae", "p99", "max", "flip", "bias", "blur", "alias", "stops", "flip-tone"})
        EXPECT_NEAR(value(name, picture, picture), 0, 1e-15) << name;
    EXPECT_NEAR(value("ssim", picture, picture), 1, 1e-12);
    EXPECT_EQ(value("psnr", picture, picture), std::numeric_limits<double>::infinity());
}

TEST(PictureMetrics, PixelErrorsByHand) {
    LinearPicture candidate = flat(two, glm::dvec3{0}), truth = candidate;
    truth.at(0, 0) = {0.3, 0, 0.6};
    candidate.at(1, 0) = {0, -0.9, 0};
    EXPECT_NEAR(value("rmse", candidate, truth), std::sqrt((0.09 + 0.36 + 0.81) / 6), 1e-15);
    EXPECT_NEAR(value("psnr", candidate, truth), -10 * std::log10(1.26 / 6), 1e-13);
    EXPECT_NEAR(value("mae", candidate, truth), 1.8 / 6, 1e-15);
    EXPECT_NEAR(value("max", candidate, truth), 0.9, 1e-15);
}

/// A stop is a factor of 2. What is darker than 2^-14 counts as that: black lies one stop below 2^-13.
TEST(PictureMetrics, StopsByHand) {
    const LinearPicture truth(one, glm::dvec3{0.25, 8, 0x1p-13}), candidate(one, glm::dvec3{1, 4, -3});
    EXPECT_NEAR(value("stops", candidate, truth), (2 + 1 + 1) / 3.0, 1e-15);
    EXPECT_EQ(value("stops", flat(one, glm::dvec3{0}), flat(one, glm::dvec3{0x1p-20})), 0);
}

/// 1 becomes 1/2, 3 becomes 3/4: FLIP itself would cut both to white.
TEST(PictureMetrics, TonesBeyondWhiteAreToldApart) {
    const auto tone = [](double a, double b) {
        return value("flip-tone", flat(small, glm::dvec3{a}), flat(small, glm::dvec3{b}));
    };
    EXPECT_EQ(value("flip", flat(small, glm::dvec3{3}), flat(small, glm::dvec3{1})), 0);
    EXPECT_NEAR(tone(3, 1), value("flip", flat(small, glm::dvec3{0.75}), flat(small, glm::dvec3{0.5})),
                1e-15);
    EXPECT_EQ(tone(-1, 0), 0);
}

TEST(PictureMetrics, PercentileIsTheNearestRank) {
    LinearPicture candidate = flat({200, 1}, glm::dvec3{0}), truth = candidate;
    for (int x = 0; x < 200; ++x) candidate.at(x, 0).g = (x * 7 % 200 + 1) / 200.0;  // 1 to 200, shuffled
    EXPECT_EQ(value("p99", candidate, truth), 198 / 200.0);
    EXPECT_EQ(value("p99", flat(one, glm::dvec3{0.25}), flat(one, glm::dvec3{0})), 0.25);
}

TEST(PictureMetrics, WhatIsNoNumberIsNeverAGoodValue) {
    LinearPicture candidate = noise(small, 2);
    const LinearPicture truth = candidate;
    candidate.at(3, 4).g = std::numeric_limits<double>::quiet_NaN();
    for (const char* name : {"rmse", "mae", "max", "stops"})
        EXPECT_EQ(value(name, candidate, truth), std::numeric_limits<double>::infinity()) << name;
    EXPECT_EQ(value("psnr", candidate, truth), -std::numeric_limits<double>::infinity());
    for (const char* name : {"flip", "flip-tone", "ssim", "alias"})
        EXPECT_TRUE(std::isnan(value(name, candidate, truth))) << name;
}

TEST(PictureMetrics, AMaskChoosesPixelsAndChangesNone) {
    const PictureMetric& mae = *find_picture_metric("mae");
    LinearPicture candidate = flat(two, glm::dvec3{0}), truth = candidate;
    candidate.at(1, 0) = glm::dvec3{0.5};
    Plane<std::uint8_t> mask(two, 0);
    EXPECT_TRUE(std::isnan(measured(mae, mae.map(candidate, truth), mask)));
    mask.at(1, 0) = 1;
    EXPECT_EQ(measured(mae, mae.map(candidate, truth), mask), 0.5);
    EXPECT_THROW(measured(mae, mae.map(candidate, truth), Plane<std::uint8_t>(one, 1)),
                 std::invalid_argument);
}

TEST(PictureMetrics, RefusePicturesOfDifferentSizes) {
    for (const PictureMetric& metric : picture_metrics(LightRange::beyond_white))
        EXPECT_THROW(metric.map(flat(one, glm::dvec3{0}), flat(two, glm::dvec3{0})), std::invalid_argument)
            << metric.name;
}

/// The split is an identity, also where windows are cut short by the border.
TEST(PictureMetrics, BiasBlurAndAliasAddUpToTheMeanSquare) {
    const LinearPicture truth = noise(small, 3), candidate = noise(small, 4);
    double sum = 0;
    for (const char* name : {"bias", "blur", "alias"}) sum += std::pow(value(name, candidate, truth), 2);
    EXPECT_NEAR(sum, std::pow(value("rmse", candidate, truth), 2), 1e-14);
}

TEST(PictureMetrics, EachShareOfTheSplitIsWhatItIsCalled) {
    const LinearPicture truth = noise({8, 8}, 5);
    LinearPicture lifted = truth, faded = truth, constant = flat({8, 8}, glm::dvec3{0.5}), rough = constant;
    glm::dvec3 mean{0};
    for (const glm::dvec3& p : truth.pixels()) mean += p / 64.0;
    for (glm::dvec3& p : lifted.pixels()) p += 0.125;
    for (glm::dvec3& p : faded.pixels()) p = mean + 0.5 * (p - mean);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) rough.at(x, y) += (x + y) % 2 == 0 ? 0.25 : -0.25;
    EXPECT_NEAR(value("bias", lifted, truth), 0.125, 1e-15);
    EXPECT_NEAR(value("alias", lifted, truth), 0, 1e-15);
    EXPECT_NEAR(value("blur", faded, truth), value("rmse", faded, truth), 1e-15);
    EXPECT_NEAR(value("alias", rough, constant), 0.25, 1e-15);
    EXPECT_EQ(value("bias", rough, constant), 0);
}

/// (2 a b + c1) (2 s + c2) / ((a^2 + b^2 + c1) (va + vb + c2)) of two constants: the variances are 0.
TEST(PictureMetrics, SsimOfConstants) {
    const double b = 1.055 * std::pow(0.25, 1 / 2.4) - 0.055, c1 = 1e-4;
    EXPECT_NEAR(value("ssim", flat(small, glm::dvec3{0.25}), flat(small, glm::dvec3{1})),
                (2 * b + c1) / (1 + b * b + c1), 1e-9);
}

/// Black against white has no features, dL = 100 and no chroma; the greatest difference is green's from blue,
/// (87.7362, -86.1787, 83.1826) and (32.2982, 79.1936, -107.8586) in L*a*b*, whose a* and b* Hunt's rule
/// multiplies by L / 100. So e = 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m).
TEST(PictureMetrics, FlipOfBlackAndWhiteByHand) {
    const double d = 87.7362 - 32.2982, a = 0.877362 * -86.1787 - 0.322982 * 79.1936,
                 b = 0.877362 * 83.1826 - 0.322982 * -107.8586;
    const double greatest = std::pow(d + std::hypot(a, b), 0.7);
    const double expected = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * greatest) / (0.6 * greatest);
    EXPECT_NEAR(value("flip", flat(small, glm::dvec3{0}), flat(small, glm::dvec3{1})), expected, 1e-5);
    EXPECT_NEAR(expected, 0.9674, 1e-4);
}

TEST(PictureMetrics, FlipOfGreenAndBlueIsOneAndSymmetric) {
    const LinearPicture green = flat(small, {0, 1, 0}), blue = flat(small, {0, 0, 1});
    EXPECT_NEAR(value("flip", green, blue), 1, 1e-12);
    const LinearPicture a = noise(small, 6), b = noise(small, 7);
    EXPECT_EQ(value("flip", a, b), value("flip", b, a));
}

/// Differences in greys are measured in lightness alone: 18 % grey has L* = 49.496, so 49.496^0.7 against
/// black.
TEST(PictureMetrics, FlipOfGreysByHand) {
    const double greatest = std::pow(55.4380 + std::hypot(-101.1880, 107.8176), 0.7);
    const double expected = std::pow(116 * std::cbrt(0.18) - 16, 0.7) * 0.95 / (0.4 * greatest);
    EXPECT_NEAR(value("flip", flat(small, glm::dvec3{0.18}), flat(small, glm::dvec3{0})), expected, 1e-5);
}

/// A white pixel on black: the feature kernels see their own greatest taps there. At 67.02 pixels per degree
/// the Gaussian has deviation s = 0.041 * 67.02 px = 2.748; at the pixel itself the first derivative is 0 and
/// the second -1 / (sum of its negative taps) times 1 / (sum of the Gaussian), twice at right angles.
TEST(PictureMetrics, FlipSeesAPointWhereItIsAsTheKernelsSay) {
    const double s = 0.5 * 0.082 * 3840 * std::acos(-1.0) / 180;
    double negative = 0, gauss = 0, csf = 0;
    for (int i = -int(std::ceil(3 * s)); i <= int(std::ceil(3 * s)); ++i) {
        const double g = std::exp(-i * i / (2 * s * s)), second = (i * i / (s * s) - 1) * g;
        gauss += g;
        if (second < 0) negative -= second;
    }
    const double degree = 3840 * std::acos(-1.0) / 180, pi2 = std::acos(-1.0) * std::acos(-1.0);
    for (int i = -10; i <= 10; ++i) csf += std::exp(-pi2 * (i / degree) * (i / degree) / 0.0047);
    const Resolution size{41, 41};
    LinearPicture black = flat(size, glm::dvec3{0}), point = black;
    point.at(20, 20) = glm::dvec3{1};
    const double feature = std::sqrt(1 / (negative * gauss));  // |(p, p)| / sqrt 2 = p
    const double grey = 1 / (csf * csf), lightness = 116 * std::cbrt(grey) - 16;
    const PictureMetric& flip = *find_picture_metric("flip");
    const double seen = flip.map(point, black).at(20, 20);
    // Only lightness would differ, were red-green and blue-yellow filtered alike; they are constant for grey.
    const double colour =
        std::pow(lightness, 0.7) * 0.95 / (0.4 * std::pow(55.4380 + std::hypot(-101.1880, 107.8176), 0.7));
    EXPECT_NEAR(seen, std::pow(colour, 1 - feature), 2e-5);
}

}  // namespace
}  // namespace zproof
