/// Normal maps: highlights of many normals against values worked by hand, and against sums over normals.
#include <gtest/gtest.h>

#include <cmath>

#include "filters/methods/catalogue.h"
#include "filters/normals/highlight.h"
#include "filters/normals/normal_study.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof::normals {
namespace {

constexpr glm::dvec3 up{0, 0, 1};

glm::dvec3 leaning(double slope) { return glm::normalize(glm::dvec3{slope, 0, 1}); }

/// At 60 degrees the cosine is 1/2.
TEST(Highlight, OfOneNormalIsThePowerOfTheCosine) {
    const glm::dvec3 h = leaning(std::sqrt(3.0));
    EXPECT_NEAR(blinn_phong(up, h, 2), 0.25, 1e-15);
    EXPECT_NEAR(toksvig(up, h, 2), 0.25, 1e-15);
    EXPECT_EQ(blinn_phong(-up, up, 2), 0);
    EXPECT_NEAR(of_mean_normal(0.5 * up, h, 2), 0.25, 1e-15);
}

/// |N| = 1/2, s = 1: f = 0.5 / (0.5 + 0.5) = 1/2, and towards h itself (1 + 0.5) / 2.
TEST(Highlight, ToksvigsIsBroaderAndFainterTheShorterTheMeanNormal) {
    EXPECT_NEAR(toksvig(0.5 * up, up, 1), 0.75, 1e-15);
    EXPECT_NEAR(toksvig(0.5 * up, leaning(std::sqrt(3.0)), 1), 0.75 * std::sqrt(0.5), 1e-15);
    EXPECT_EQ(toksvig({}, up, 8), 0);
}

/// Without bumps exp(-s tan^2 / 2). With slopes of +-b in x, as often each: 1 / sqrt(s b^2 + 1) towards h
/// itself.
TEST(Highlight, LeansIsAGaussianOfSlopes) {
    EXPECT_NEAR(lean({}, leaning(0.5), 4), std::exp(-0.5), 1e-15);
    EXPECT_NEAR(lean({.xx = 0.75}, up, 4), 0.5, 1e-15);
    EXPECT_NEAR(lean({.mean = {0.5, 0}, .xx = 0.25}, leaning(0.5), 4), 1, 1e-15) << "all normals lean alike";
}

/// A second definition of LEAN: the mean of single highlights exp(-s d^2 / 2) over slopes that are normally
/// distributed.
TEST(Highlight, LeansIsTheMeanOverAGaussianOfBumps) {
    constexpr double s = 20, x_deviation = 0.3, y_deviation = 0.2, correlation = 0.5, step = 1.0 / 64;
    const glm::dvec2 mean{0.1, -0.2}, h{0.3, 0.1};
    double sum = 0, weights = 0;
    SlopeMoments moments;
    for (double a = -6; a <= 6; a += step)
        for (double b = -6; b <= 6; b += step) {
            const double weight = std::exp(-(a * a + b * b) / 2);
            const glm::dvec2 slope =
                mean +
                glm::dvec2{x_deviation * a,
                           y_deviation * (correlation * a + std::sqrt(1 - correlation * correlation) * b)};
            const glm::dvec2 d = h - slope;
            sum += weight * std::exp(-s * glm::dot(d, d) / 2), weights += weight;
            moments.mean += weight * slope;
            moments.xx += weight * slope.x * slope.x, moments.yy += weight * slope.y * slope.y;
            moments.xy += weight * slope.x * slope.y;
        }
    moments.mean /= weights, moments.xx /= weights, moments.yy /= weights, moments.xy /= weights;
    EXPECT_NEAR(lean(moments, glm::normalize(glm::dvec3{h, 1}), s), sum / weights, 1e-6);
}

/// Codes 128, 128, 255: 1/255, 1/255 and 1 before they are made a unit.
TEST(NormalMap, IsReadFromCodes) {
    const Image image{
        .name = "n", .width = 2, .height = 1, .texels = {128, 128, 255, 255, 128, 128, 127, 255}};
    EXPECT_THROW(normal_map(image), std::runtime_error);
    const Image flat{.name = "n", .width = 1, .height = 1, .texels = {128, 128, 255, 255}};
    EXPECT_NEAR(slope(normal_map(flat).at(0, 0)).x, 1 / 255.0, 1e-15);
    Image of_floats = flat;
    of_floats.light = {{0, 0, 1, 1}};
    EXPECT_THROW(normal_map(of_floats), std::runtime_error) << "its codes are those of light";
}

TEST(NormalMap, OfBumpsSurvivesItsCodes) {
    const NormalMap made = bumps(), read = normal_map(image_of(made));
    double steepest = 0;
    for (std::size_t i = 0; i < made.normals.size(); ++i) {
        EXPECT_LT(glm::length(made.normals[i] - read.normals[i]), 0.008) << i;
        steepest = std::max(steepest, glm::length(slope(made.normals[i])));
    }
    EXPECT_GT(steepest, 0.5);
}

std::vector<HighlightScore> scores_of(const NormalMap& map) {
    const Loaded loaded = plane_scene("bumps", image_of(map), 64, 64);
    return highlight_scores(loaded.scene, loaded.views[0], map, {.half = leaning(0.2), .shininess = 32},
                            {.method = *texture::find_method("aniso-midpoint")});
}

/// One normal everywhere: every filter keeps it. LEAN takes a Gaussian for the power: exp(-s tan^2 / 2) for
/// cos^s.
TEST(NormalStudy, OfAFlatMapIsExact) {
    const auto scores = scores_of({2, 2, std::vector<glm::dvec3>(4, up)});
    ASSERT_EQ(scores.size(), 4u);
    for (const int exact : {0, 1, 3})
        EXPECT_LT(scores[std::size_t(exact)].rmse, 1e-5) << scores[std::size_t(exact)].model;
    EXPECT_NEAR(scores[2].rmse, std::abs(std::exp(-32 * 0.04 / 2) - std::pow(1 / std::sqrt(1.04), 32)), 1e-6);
}

TEST(NormalStudy, OfBumpsRanksTheModels) {
    const auto scores = scores_of(bumps());
    const double mean_normal = scores[0].rmse, toksvig = scores[1].rmse, lean = scores[2].rmse,
                 highlights = scores[3].rmse;
    EXPECT_LT(toksvig, mean_normal);
    EXPECT_LT(lean, toksvig);
    EXPECT_LT(highlights, lean);
}

}  // namespace
}  // namespace zproof::normals
