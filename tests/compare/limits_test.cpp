/// Both sides of every limit: the last float32 that the judge must accept and the first that it must refuse,
/// both found from the bounds of the view. Views are parallel: there a corner's float32 is its place in px.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "compare/bounds/triangle_depth.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr float centre = 0.5f;

/// The last float32 from `from` towards `to` for which the predicate, true at `from` only to begin with,
/// holds.
float last_that(const std::function<bool(float)>& holds, float from, float to) {
    EXPECT_TRUE(holds(from));
    EXPECT_FALSE(holds(to));
    while (std::nextafter(from, to) != to) {
        const float middle = std::midpoint(from, to);
        (holds(middle) ? from : to) = middle;
    }
    return from;
}

TestScene bare_scene(const std::vector<Triangle>& triangles) {
    TestScene t(Projection::parallel, 1, 1, triangles);
    t.candidate_precision = raster_precision();
    return t;
}

PixelClass class_of_answer(TestScene t, std::uint32_t triangle, double depth) {
    answer(t.candidate, 0, 0, triangle, depth);
    return t.class_at(0, 0);
}

TEST(Limit, ATriangleIsOutsideBeyondEps) {
    const auto scene = [](float edge) { return bare_scene({wall_right_of(edge, 4)}); };
    const auto within = [&](float edge) {
        return double(edge) - centre <= scene(edge).candidate_eps_px(0, 0, 0);
    };
    const float last = last_that(within, centre, 0.75f);
    EXPECT_EQ(class_of_answer(scene(last), 0, 4), PixelClass::edge);
    EXPECT_EQ(class_of_answer(scene(std::nextafter(last, 1.f)), 0, 4), PixelClass::outside);
}

/// The classes of an answer on both sides of a limit: a wall's edge beyond the centre by up to `times` eps.
struct BothSides {
    PixelClass last_within, first_beyond;
};

/// `scene` makes the test scene, with the reference's answer, for a place of the edge.
BothSides around_limit(const std::function<TestScene(float)>& scene, std::uint32_t triangle, double depth,
                       double times) {
    const auto within = [&](float edge) {
        return double(edge) - centre < times * scene(edge).candidate_eps_px(0, 0, triangle);
    };
    const float last = last_that(within, centre, 0.75f);
    return {class_of_answer(scene(last), triangle, depth),
            class_of_answer(scene(std::nextafter(last, 1.f)), triangle, depth)};
}

TestScene wall_to(float edge) {
    TestScene t = bare_scene({wall_left_of(edge, 4), wall(8)});
    answer(t.reference, 0, 0, 0, 4);
    return t;
}

TEST(Limit, ATriangleShowsBesideAWallWithinEps) {
    const BothSides sides = around_limit(wall_to, 1, 8, 1);
    EXPECT_EQ(sides.last_within, PixelClass::edge);
    EXPECT_EQ(sides.first_beyond, PixelClass::hidden) << "nothing abuts the wall";
}

/// Two walls overlap evenly around the centre, side by side or one above the other.
TEST(Limit, ACrackOpensWhereUnsharedEdgesOverlapByLessThanTwiceEps) {
    for (const bool is_transposed : {false, true}) {
        const auto scene = [&](float edge) {
            const Triangle before = wall_left_of(edge, 4),
                           after = wall_right_of(2 * centre - edge, 4, -32, 32);
            TestScene t = bare_scene({is_transposed ? transposed(before) : before,
                                      is_transposed ? transposed(after) : after, wall(8)});
            answer(t.reference, 0, 0, 0, 4);
            return t;
        };
        const BothSides sides = around_limit(scene, 2, 8, 1);
        EXPECT_EQ(sides.last_within, PixelClass::abutting_edges) << is_transposed;
        EXPECT_EQ(sides.first_beyond, PixelClass::hidden) << is_transposed;
    }
}

/// One wall's edge lies at the centre: the other, up to eps beyond, abuts it.
TEST(Limit, ACrackNeedsBothEdgesWithinEps) {
    const auto scene = [](float edge) {
        TestScene t = bare_scene({wall_left_of(edge, 4), wall_right_of(centre, 4, -32, 32), wall(8)});
        answer(t.reference, 0, 0, 0, 4);
        return t;
    };
    const BothSides sides = around_limit(scene, 2, 8, 1);
    EXPECT_EQ(sides.last_within, PixelClass::abutting_edges);
    EXPECT_EQ(sides.first_beyond, PixelClass::hidden) << "the left wall covers the square by itself";
}

TEST(Limit, BackgroundIsAHoleBeyondEpsOfTheOutline) {
    const auto class_at = [](float edge) {
        TestScene t = bare_scene({wall_left_of(edge, 4)});
        answer(t.reference, 0, 0, 0, 4);
        return t.class_at(0, 0);
    };
    const auto within = [](float edge) {
        return double(edge) - centre < bare_scene({wall_left_of(edge, 4)}).candidate_eps_px(0, 0, 0);
    };
    const float last = last_that(within, centre, 0.75f);
    EXPECT_EQ(class_at(last), PixelClass::edge);
    EXPECT_EQ(class_at(std::nextafter(last, 1.f)), PixelClass::hole);
}

TEST(Limit, ATriangleIsHiddenWhereDepthBoundsNoLongerMeet) {
    const auto scene = [](float behind) { return bare_scene({wall(4), wall(behind)}); };
    const auto class_at = [&](float behind) {
        TestScene t = scene(behind);
        answer(t.reference, 0, 0, 0, 4);
        return class_of_answer(t, 1, behind);
    };
    const auto meet = [&](float behind) {
        const TestScene t = scene(behind);
        const ViewBounds bounds(t.view, t.candidate_precision);
        const ViewRay<double> ray(t.view, 0, 0);
        return neighbour_of(ray, bounds, corners_of(t.scene, 0)).least_inverse_depth <=
               neighbour_of(ray, bounds, corners_of(t.scene, 1)).greatest_inverse_depth;
    };
    const float last = last_that(meet, 4, 5);
    EXPECT_GT(last, 4.f);
    EXPECT_EQ(class_at(last), PixelClass::depth_tie);
    EXPECT_EQ(class_at(std::nextafter(last, 5.f)), PixelClass::hidden);
}

/// A slope of one depth unit per pixel, 8 units deep at the centre.
Triangle slope() { return {{{-31.5, -64, -24}, {32.5, -64, 40}, {-31.5, 192, -24}}}; }

TEST(Limit, DepthIsWrongBeyondItsBoundOnEitherSide) {
    for (const float limit : {7.f, 9.f}) {
        TestScene t = bare_scene({slope()});
        t.view.camera.near_depth = -64;
        answer(t.reference, 0, 0, 0, 8);
        const ViewBounds bounds(t.view, t.candidate_precision);
        const TriangleDepth depth(TriangleInView(t.view, bounds, corners_of(t.scene, 0)), bounds);
        const DepthBound bound = depth.at(0, 0);
        ASSERT_EQ(bound.truth, 8);
        const float last = last_that([&](float z) { return bound.low <= z && z <= bound.high; }, 8, limit);
        EXPECT_EQ(class_of_answer(t, 0, last), PixelClass::agree);
        EXPECT_EQ(class_of_answer(t, 0, std::nextafter(last, limit)), PixelClass::wrong_depth);
    }
}

/// The slope through the near plane at x = `cut`, to the left of which it is cut off.
TestScene cut_at(float cut) {
    TestScene t = bare_scene({{{{-31.5, -64, -24}, {32.5, -64, 40}, {-31.5, 192, -24}}}});
    t.view.camera.near_depth = 7.5 + double(cut);
    t.candidate_precision = RasterPrecision{.transform = Arithmetic::float64, .depth_roundings = 2};
    return t;
}

TEST(Limit, ATriangleIsOutsideBeyondEpsOfTheNearPlane) {
    // depth = 7.5 + x, so the plane may move by near_slack px
    const auto within = [](float cut) {
        const TestScene t = cut_at(cut);
        const ViewBounds bounds(t.view, t.candidate_precision);
        const TriangleBounds of_triangle = bounds.of(corners_of(t.scene, 0));
        return t.view.camera.near_depth - of_triangle.near_slack <= 8 + t.candidate_eps_px(0, 0, 0);
    };
    const auto class_at = [](float cut) {
        const TestScene t = cut_at(cut);
        return class_of_answer(t, 0, t.view.camera.near_depth);
    };
    const float last = last_that(within, centre, 0.75f);
    EXPECT_EQ(class_at(last), PixelClass::clip);
    EXPECT_EQ(class_at(std::nextafter(last, 1.f)), PixelClass::outside);
}

}  // namespace
}  // namespace zproof
