// Closed fronts, fragment by fragment: every pixel exactly once, whatever the slope of the edges through its
// centre.
#include <gtest/gtest.h>

#include <numeric>

#include "closed_front.h"
#include "drawing.h"
#include "rasterizer/pipeline.h"

namespace zproof::rasterizer {
namespace {

constexpr Flaws none{};

/// Correct, and every grid and snap that rules may ask for.
std::vector<Rules> watertight_rules() {
    std::vector<Rules> all{correct_rules};
    for (const Snap snap : {Snap::nearest, Snap::truncate}) {
        for (int bits = 1; bits <= 12; ++bits) all.push_back({.subpixel_bits = bits, .snap = snap});
    }
    return all;
}

/// All (p, q) with |p|, |q| <= reach and no common divisor: every slope, in all octants.
std::vector<glm::ivec2> slopes(int reach) {
    std::vector<glm::ivec2> found;
    for (int p = -reach; p <= reach; ++p) {
        for (int q = -reach; q <= reach; ++q) {
            if (std::gcd(p, q) == 1) found.push_back({p, q});
        }
    }
    return found;
}

TEST(ClosedFront, FanOverEverySlopeIsHitOncePerPixel) {
    for (const Rules& rules : watertight_rules()) {
        for (const int hub : {0, 7, 15, 31}) {
            SCOPED_TRACE(testing::Message() << rules.subpixel_bits << " bits, hub " << hub);
            ASSERT_EQ(flaws_of(fan_through_centres(hub, 40), rules), none);
        }
    }
}

TEST(ClosedFront, GridShearedByEverySlopeIsHitOncePerPixel) {
    for (const glm::ivec2 u : slopes(4)) {
        for (const glm::ivec2 v : slopes(4)) {
            if (u.x * v.y == u.y * v.x) continue;
            SCOPED_TRACE(testing::Message() << u.x << " " << u.y << " and " << v.x << " " << v.y);
            ASSERT_EQ(flaws_of(sheared_grid(u, v)), none);
        }
    }
}

TEST(ClosedFront, SliversAreHitOncePerPixel) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        ASSERT_EQ(flaws_of(slivers(random, Direction::across)), none);
        ASSERT_EQ(flaws_of(slivers(random, Direction::down)), none);
    }
}

TEST(ClosedFront, FarBeyondTheGuardBandIsHitOncePerPixel) {
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Front front = far_fan(random);
        ASSERT_EQ(flaws_of(front), none);
        ASSERT_EQ(flaws_of(front, {.subpixel_bits = 12}), none);
    }
}

TEST(ClosedFront, SeenFromInsideThroughTheNearPlaneIsHitOncePerPixel) {
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        ASSERT_EQ(flaws_of(box_from_inside(random)), none);
    }
}

/// The same fronts by another fill rule.
Flaws flaws_by(FillRule fill) {
    const Rules rules{.fill = fill};
    std::mt19937 random(1);
    Flaws sum;
    for (const Front& front : {fan_through_centres(15, 40), sheared_grid({2, 1}, {-1, 3}),
                               slivers(random, Direction::across), slivers(random, Direction::down)}) {
        const Flaws flaws = flaws_of(front, rules);
        sum.holes += flaws.holes;
        sum.double_hits += flaws.double_hits;
    }
    return sum;
}

TEST(ClosedFront, WithoutOwnersHasHolesAndNoDoubleHits) {
    const Flaws flaws = flaws_by(FillRule::exclusive);
    EXPECT_GT(flaws.holes, 100u);
    EXPECT_EQ(flaws.double_hits, 0u);
}

TEST(ClosedFront, WithTwoOwnersHasDoubleHitsAndNoHoles) {
    const Flaws flaws = flaws_by(FillRule::inclusive);
    EXPECT_EQ(flaws.holes, 0u);
    EXPECT_GT(flaws.double_hits, 100u);
}

TEST(CountFragments, CountsWhatIsHiddenToo) {
    const Triangle near_one = at_pixels(0, 0, 8, 0, 0, 8);
    Triangle far_one = near_one;
    for (glm::vec3& p : far_one) p.z = -2;
    const Scene scene = scene_of({near_one, far_one, near_one});
    const Plane<std::uint32_t> hits = count_fragments(correct_rules, scene, raster_view(8, 8));
    EXPECT_EQ(hits.at(0, 0), 3u);
    EXPECT_EQ(hits.at(7, 7), 0u);
}

TEST(CountFragments, AgreesWithTheFrameOnWhatIsCovered) {
    std::mt19937 random(3);
    const Scene scene = scene_of(random_triangles(random, 20, {-20, -150, -9}, {150, 20, -1}));
    const Frame frame = render_by(correct_rules, scene, raster_view(128, 128));
    const Plane<std::uint32_t> hits = count_fragments(correct_rules, scene, raster_view(128, 128));
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            ASSERT_EQ(hits.at(x, y) > 0, frame.primitive.at(x, y) != PrimitiveId::none);
        }
    }
}

}  // namespace
}  // namespace zproof::rasterizer
