#include "lessons/depth/format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zproof::study::depth {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

TEST(DepthFormat, NearAndFarAreTheEndsOfEveryFormat) {
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        const Coder coder{format, {0.5, 64}};
        const double at_near = format.coding == Coding::reversed ? 1 : 0;
        EXPECT_NEAR(coder.ideal(0.5), at_near, 1e-15);
        EXPECT_NEAR(coder.ideal(64), 1 - at_near, 1e-15);
        EXPECT_NEAR(coder.stored(coder.of_depth(0.5f)), at_near, 1e-6);
        EXPECT_NEAR(coder.stored(coder.of_depth(64)), 1 - at_near, 1e-6);
    }
}

TEST(DepthFormat, TheFormulaAndItsInverseAreOne) {
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        const Coder coder{format, {0.1, 1000}};
        for (const double depth : {0.1, 0.11, 1.0, 30.0, 999.0})
            EXPECT_NEAR(coder.depth_of(coder.ideal(depth)) / depth, 1, 1e-11);
    }
}

// The hyperbola of the lessons: P3 = (f + n - 2 f n / z) / (f - n).
TEST(DepthFormat, OpenGlsRangeIsTheLessonsFormula) {
    const double n = 0.5, f = 64;
    const Coder coder{format_named("z-float32-gl"), {n, f}};
    for (const double depth : {0.5, 2.0, 40.0})
        EXPECT_NEAR(coder.ideal(depth), ((f + n - 2 * f * n / depth) / (f - n) + 1) / 2, 1e-15);
}

TEST(DepthFormat, AWholeNumberOfStepsIsStored) {
    const Coder coder{format_named("z-unorm16"), {1, 10}};
    for (const float s : {0.1f, 0.5f, 0.9f}) {
        const double steps = coder.stored(s) * 65535;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_LE(std::abs(coder.stored(s) - double(s)), 0.5 / 65535 + 1e-12);
    }
}

TEST(DepthFormat, OddDepthsAreValues) {
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        const Coder coder{format, {0.1, 1000}};
        for (const float depth : {0.0f, -0.0f, -1.0f, infinite, -infinite, nan}) {
            const double stored = coder.stored(coder.of_depth(depth));
            EXPECT_TRUE(std::isnan(stored) || (stored >= 0 && stored <= 1)) << depth;
            EXPECT_FALSE(coder.is_nearer(stored, nan));
            EXPECT_FALSE(coder.is_nearer(nan, stored));
        }
        EXPECT_EQ(std::isnan(coder.stored(nan)), format.store == Store::float32);
    }
    // Behind the eye a + b/d lies beyond far: why triangles are clipped before they are divided.
    EXPECT_EQ(Coder(format_named("z-float32"), {0.1, 1000})
                  .stored(Coder(format_named("z-float32"), {0.1, 1000}).of_depth(-1)),
              1);
}

TEST(DepthFormat, AnInfiniteFarPlaneLeavesZAndReversed) {
    const Planes planes{0.25, std::numeric_limits<double>::infinity()};
    EXPECT_TRUE(can_hold(Coding::z, planes));
    EXPECT_FALSE(can_hold(Coding::w, planes));
    EXPECT_FALSE(can_hold(Coding::logarithmic, planes));
    const Coder coder{format_named("reversed-float32"), planes};
    EXPECT_EQ(coder.of_depth(0.5f), 0.5f);
    EXPECT_EQ(coder.of_depth(infinite) != coder.of_depth(infinite), true) << "inf / inf";
    EXPECT_EQ(coder.of_inverse(0), 0);
}

}  // namespace
}  // namespace zproof::study::depth
