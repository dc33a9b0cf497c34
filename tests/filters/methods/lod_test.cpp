#include "filters/methods/lod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

Footprint steps(const glm::dvec2& per_x, const glm::dvec2& per_y) { return {.per_x = per_x, .per_y = per_y}; }

/// Of the image of the unit circle with semi-axes 8 and 2, seen at any turn of the pixel.
Footprint ellipse_8_by_2(double turn_of_texture, double turn_of_pixel) {
    const double c = std::cos(turn_of_texture), s = std::sin(turn_of_texture), p = std::cos(turn_of_pixel),
                 q = std::sin(turn_of_pixel);
    const glm::dvec2 major{8 * c, 8 * s}, minor{-2 * s, 2 * c};
    return steps(p * major + q * minor, -q * major + p * minor);
}

TEST(Lod, OfACircleIsItsRadiusForEveryRuleButPbrts) {
    for (const double texels : {0.25, 1.0, 3.0, 64.0}) {
        const Footprint circle = steps({texels, 0}, {0, -texels});
        for (const LodRule rule :
             {lod_gl_maximum, lod_ellipse_major, lod_root_mean_square, lod_area, lod_chebyshev})
            EXPECT_NEAR(rule(circle), std::log2(texels), 1e-15 * 8);
        EXPECT_DOUBLE_EQ(lod_pbrt(circle), std::log2(texels) + 1);
    }
}

TEST(Lod, OfAnEllipseDependsOnItsAxesAlone) {
    for (double turn = 0; turn < 3; turn += 0.37) {
        const Footprint f = ellipse_8_by_2(turn, 2.1 * turn);
        EXPECT_NEAR(lod_ellipse_major(f), 3, 1e-14);
        EXPECT_NEAR(lod_area(f), 2, 1e-14);
        EXPECT_NEAR(lod_root_mean_square(f), std::log2(std::sqrt(34.0)), 1e-14);
    }
}

TEST(Lod, OfStepsIsThatOfTheLongerOrItsLargestPart) {
    const Footprint f = steps({3, 4}, {-1, 2});
    EXPECT_DOUBLE_EQ(lod_gl_maximum(f), std::log2(5.0));
    EXPECT_DOUBLE_EQ(lod_chebyshev(f), 2);
    EXPECT_DOUBLE_EQ(lod_pbrt(f), 3);
    EXPECT_DOUBLE_EQ(lod_root_mean_square(f), std::log2(std::sqrt(15.0)));
    EXPECT_DOUBLE_EQ(lod_area(f), std::log2(std::sqrt(10.0)));
}

TEST(Lod, RulesAreOrderedAsTheirDefinitionsAre) {
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        const Footprint f = random_footprint(seed);
        const double slack = 1e-12;  // of the logarithms of the same real number, rounded differently
        EXPECT_LE(lod_area(f), lod_root_mean_square(f) + slack);
        EXPECT_LE(lod_root_mean_square(f), lod_gl_maximum(f) + slack);
        EXPECT_LE(lod_gl_maximum(f), lod_ellipse_major(f) + slack);
        EXPECT_LE(lod_chebyshev(f), lod_gl_maximum(f) + slack);
        EXPECT_LE(lod_gl_maximum(f), lod_chebyshev(f) + 0.5 + slack);
        EXPECT_LE(lod_ellipse_major(f), lod_root_mean_square(f) + 0.5 + slack);
    }
}

TEST(Lod, IsBiasedBeforeItIsClamped) {
    EXPECT_EQ(lod_in_chain(3, {.lod_bias = 2}, 10), 5);
    EXPECT_EQ(lod_in_chain(3, {.lod_bias = 2, .lod_max = 4}, 10), 4);
    EXPECT_EQ(lod_in_chain(3, {.lod_bias = -2, .lod_min = 2}, 10), 2);
    EXPECT_EQ(lod_in_chain(1, {.lod_bias = 2, .lod_max = 1.5}, 10), 1.5);
    EXPECT_EQ(lod_in_chain(-3, {}, 10), 0);
    EXPECT_EQ(lod_in_chain(30, {}, 10), 9);
}

TEST(Lod, OfAnythingButANumberIsTheLastLevel) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(lod_in_chain(std::nan(""), {}, 7), 6);
    EXPECT_EQ(lod_in_chain(infinity, {}, 7), 6);
    EXPECT_EQ(lod_in_chain(-infinity, {}, 7), 0);
}

TEST(Lod, NearestLevelGoesToTheFinerOneHalfWay) {
    EXPECT_EQ(nearest_level(0), 0);
    EXPECT_EQ(nearest_level(0.5), 0);
    EXPECT_EQ(nearest_level(0.500001), 1);
    EXPECT_EQ(nearest_level(1), 1);
    EXPECT_EQ(nearest_level(1.5), 1);
    EXPECT_EQ(nearest_level(1.75), 2);
}

}  // namespace
}  // namespace zproof::texture
