#include "rasterizer/snap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawing.h"
#include "rasterizer/edge_function.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {
namespace {

TEST(Snap, RoundsToTheNearestGridPointTiesToEven) {
    const SubpixelGrid grid;
    EXPECT_EQ(grid.snap(0), 0);
    EXPECT_EQ(grid.snap(1), 256);
    EXPECT_EQ(grid.snap(0.5 / 256), 0);
    EXPECT_EQ(grid.snap(1.5 / 256), 2);
    EXPECT_EQ(grid.snap(2.5 / 256), 2);
    EXPECT_EQ(grid.snap(-0.5 / 256), 0);
    EXPECT_EQ(grid.snap(-1.5 / 256), -2);
    EXPECT_EQ(grid.snap(-2.5 / 256), -2);
    EXPECT_EQ(grid.snap(std::nextafter(0.5 / 256, 1.0)), 1);
    EXPECT_EQ(grid.snap(std::nextafter(1.5 / 256, 0.0)), 1);
    EXPECT_EQ(grid.snap(guard_band_px(8)), 1 << 24);
    EXPECT_EQ(grid.snap(-guard_band_px(8)), -(1 << 24));
}

TEST(Snap, TruncatesTowardsZeroWhereTheRuleSaysSo) {
    const SubpixelGrid grid{.snapping = Snap::truncate};
    EXPECT_EQ(grid.snap(std::nextafter(1.0, 0.0)), 255);
    EXPECT_EQ(grid.snap(1), 256);
    EXPECT_EQ(grid.snap(std::nextafter(-1.0, 0.0)), -255);
    EXPECT_EQ(grid.snap(-1), -256);
}

TEST(Snap, NeverMovesAPointByMoreThanHalfAGridStep) {
    const SubpixelGrid grid;
    std::mt19937 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const double x = uniform(random, -70, 70);
        ASSERT_LE(std::abs(grid.snap(x) / 256.0 - x), 1.0 / 512) << x;
    }
}

TEST(Snap, PixelsWithinAnIntervalAreThoseSampledInIt) {
    const SubpixelGrid grid;
    for (std::int32_t c = -1000; c <= 1000; ++c) {
        const int first = grid.first_pixel_from(c), last = grid.last_pixel_until(c);
        ASSERT_GE(grid.sample(first), c);
        ASSERT_LT(grid.sample(first - 1), c);
        ASSERT_LE(grid.sample(last), c);
        ASSERT_GT(grid.sample(last + 1), c);
    }
}

TEST(Snap, CornersOfTheImageSnapToItsCorners) {
    const ViewSetup setup(raster_view(640, 480), correct_rules);
    const auto upper_left = setup.snap(setup.clip_from_world({0, 0, -1}));
    const auto lower_right = setup.snap(setup.clip_from_world({640, -480, -1}));
    ASSERT_TRUE(upper_left && lower_right);
    EXPECT_EQ(upper_left->p, (SnappedPoint{0, 0}));
    EXPECT_EQ(lower_right->p, (SnappedPoint{640 * 256, 480 * 256}));
}

TEST(Snap, EveryGridKeepsItsStepsWithinTheGuardBand) {
    for (int bits = 1; bits <= 12; ++bits) {
        const SubpixelGrid grid{.bits = bits};
        EXPECT_LE(grid.snap(guard_band_px(bits)), 1 << 24) << bits;
        EXPECT_GE(guard_band_px(bits), 4096) << bits;
    }
}

// The corners of the guard band are the worst case that guard_band_px promises to fit.
TEST(EdgeFunction, StaysExactInADoubleAllOverTheGuardBand) {
    constexpr std::int32_t far = 1 << 24;
    constexpr EdgeFunction diagonal = edge_between({-far, -far}, {far, far});
    constexpr std::int64_t greatest = diagonal.at({-far, far});
    static_assert(greatest == std::int64_t{1} << 50);
    static_assert(std::int64_t(double(greatest - 1)) == greatest - 1);
    SUCCEED();
}

TEST(EdgeFunction, IsPositiveInsideAClockwiseTriangle) {
    constexpr SnappedPoint a{0, 0}, b{100, 0}, c{0, 100}, inside{20, 20};
    static_assert(edge_between(a, b).at(inside) > 0);
    static_assert(edge_between(b, c).at(inside) > 0);
    static_assert(edge_between(c, a).at(inside) > 0);
    static_assert(edge_between(a, b).covers({50, 0}), "a top edge owns its samples");
    static_assert(edge_between(c, a).covers({0, 50}), "a left edge owns its samples");
    static_assert(!edge_between(b, c).covers({50, 50}), "a right edge does not");
    SUCCEED();
}

}  // namespace
}  // namespace zproof::rasterizer
