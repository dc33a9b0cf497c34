/// Depths and gaps at the limit of what is promised, and a hundredth beyond it.
#include <gtest/gtest.h>

#include <cmath>

#include "frame/precision_text.h"
#include "test_scene.h"

namespace zproof {
namespace {

PixelClass class_of_depth(TestScene t, int x, int y, double depth) {
    answer(t.candidate, x, y, 0, depth);
    return t.class_at(x, y);
}

TEST(HeldToThePromise, ADeclaredShareOfDepthIsThatShare) {
    TestScene t(Projection::parallel, 2, 2, {wall(4)});
    answer_everywhere(t.reference, 0, 4);
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-9, .depth_relative = 0.5};
    for (const double depth : {2.0, 4.0, 6.0}) EXPECT_EQ(class_of_depth(t, 0, 0, depth), PixelClass::agree);
    for (const double depth : {1.98, 6.02, 7.99})
        EXPECT_EQ(class_of_depth(t, 0, 0, depth), PixelClass::wrong_depth);
}

/// A triangle in a plane through the eye (perspective) or along the view (parallel), over the centre of pixel
/// (1, 1).
TestScene edge_on(Projection projection) {
    return {projection, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}}};
}

TEST(HeldToThePromise, ATriangleSeenEdgeOnHasADepthBetweenItsCorners) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        TestScene t = edge_on(projection);
        t.candidate_precision = BoundedPrecision{.eps_px = 1e-3, .depth_relative = 1e-3};
        for (const double depth : {1.999, 2.0, 5.0, 8.0, 8.007})
            EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::edge) << depth;
        for (const double depth : {1e-3, 1.99, 8.02, 99.0, 1e30})
            EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::wrong_depth) << depth;
    }
}

/// A float32 ray may take such a plane for any other, but it ends at far.
TEST(HeldToThePromise, ARaysDepthLiesBetweenNearAndFar) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        TestScene t = edge_on(projection);
        t.candidate_precision = ray_precision();
        EXPECT_EQ(class_of_depth(t, 1, 1, 5), PixelClass::edge);
        for (const double depth : {2e-3, 2000.0, 1e30})
            EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::wrong_depth) << depth;
    }
}

/// A z-buffer's plane says nothing of it. But z lies in [0, 1], and what is shown is what was compared with
/// the wall behind.
TEST(HeldToThePromise, AZBuffersDepthOfATriangleEdgeOnIsOneThatPassedItsTest) {
    TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}, wall(16)});
    t.candidate_precision = precision_from_word("d3d11");
    answer_everywhere(t.reference, 1, 16);
    for (const double depth : {2.0, 5.0, 15.9, 16.0})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::edge) << depth;
    const double near = t.view.camera.near_depth, far = t.view.camera.far_depth;
    for (const double depth : {near * 0.99, 16.1, 99.0, far * 1.01})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::wrong_depth) << depth;
}

/// A sliver behind its neighbour may come to lie beside it when their corners are moved: then that neighbour
/// hides none of it. One that it shares no edge with does.
TEST(HeldToThePromise, AZBuffersDepthOfASliverIsNotThatOfTheNeighbourItIsFoldedBehind) {
    const Triangle sliver{{{1.4995, -8, 2}, {1.4995, 24, 2}, {1.49951, 8, 8}}};
    for (const bool is_neighbour : {true, false}) {
        const double left = is_neighbour ? 1.4995 : 1;
        TestScene t(Projection::perspective, 4, 4,
                    {sliver, Triangle{{{left, -8, 2}, {left, 24, 2}, {30, 8, 2}}}, wall(16)});
        t.candidate_precision = precision_from_word("d3d11");
        answer_everywhere(t.reference, 1, 2);
        EXPECT_EQ(class_of_depth(t, 1, 1, 2), PixelClass::depth_tie);
        EXPECT_EQ(class_of_depth(t, 1, 1, 5), is_neighbour ? PixelClass::depth_tie : PixelClass::wrong_depth);
        EXPECT_EQ(class_of_depth(t, 1, 1, 15.9),
                  is_neighbour ? PixelClass::depth_tie : PixelClass::wrong_depth);
        EXPECT_EQ(class_of_depth(t, 1, 1, 16.1), PixelClass::wrong_depth);
    }
}

/// So is a sliver's whose plane tells how near it is at least, but not how far.
TEST(HeldToThePromise, AZBuffersDepthThatMayBeInfiniteIsOneThatPassedItsTest) {
    TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.50596, 8, 8}}}, wall(16)});
    t.candidate_precision = precision_from_word("d3d11");
    answer_everywhere(t.reference, 1, 16);
    const ViewBounds bounds(t.view, t.candidate_precision);
    const Neighbour sliver = neighbour_of(ViewRay<double>(t.view, 1, 1), bounds, corners_of(t.scene, 0));
    EXPECT_LT(sliver.least_inverse_depth, 0);
    EXPECT_LT(sliver.greatest_inverse_depth, 1.5);
    for (const double depth : {2.0, 15.9, 16.0})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::edge) << depth;
    for (const double depth : {0.6, 16.1, 99.0})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::wrong_depth) << depth;
}

/// In steps, half of one is added to what passed its test and to the planes, and no more.
TEST(HeldToThePromise, ADepthOfATriangleEdgeOnMayBeHalfAStepBeyondWhatHoldsIt) {
    TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}, wall(16)});
    RasterPrecision in_steps = std::get<RasterPrecision>(precision_from_word("d3d11"));
    in_steps.depth_step = 0.4;
    t.candidate_precision = in_steps;
    answer_everywhere(t.reference, 1, 16);
    for (const double depth : {t.view.camera.near_depth - 0.198, 5.0, 16.198})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::edge) << depth;
    for (const double depth : {t.view.camera.near_depth - 0.202, 16.202})
        EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::wrong_depth) << depth;
}

TEST(HeldToThePromise, ARaysDepthOfATriangleEdgeOnMayBeHalfAStepBeyondThePlanes) {
    TestScene t = edge_on(Projection::perspective);
    auto in_steps = std::get<RayPrecision>(Precision(ray_precision()));
    const double near = t.view.camera.near_depth, far = t.view.camera.far_depth;
    for (const double depth_step : {0.0, 0.4}) {
        in_steps.depth_step = depth_step;
        t.candidate_precision = in_steps;
        EXPECT_EQ(class_of_depth(t, 1, 1, near - 0.198) == PixelClass::edge, depth_step > 0);
        EXPECT_EQ(class_of_depth(t, 1, 1, far + 0.198) == PixelClass::edge, depth_step > 0);
        EXPECT_EQ(class_of_depth(t, 1, 1, near - 0.202), PixelClass::wrong_depth);
        EXPECT_EQ(class_of_depth(t, 1, 1, far + 0.202), PixelClass::wrong_depth);
    }
}

/// Nothing bounds a mean by such weights, but no renderer shows what lies behind the eye.
TEST(HeldToThePromise, ADepthBehindTheEyeIsNone) {
    TestScene t = edge_on(Projection::perspective);
    t.candidate_precision = precision_from_word("pytorch3d");
    EXPECT_EQ(class_of_depth(t, 1, 1, 5), PixelClass::edge);
    EXPECT_EQ(class_of_depth(t, 1, 1, -5), PixelClass::invalid);
}

/// Near leaves a quadrilateral of the triangle. One of its diagonals passes 1/6 px beside the centre of pixel
/// (6, 4).
TEST(HeldToThePromise, ATriangleThatNearCutsHasAGapAlongADiagonal) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 2}, {16, -8, 8}, {16, 24, 8}}}});
    t.view.camera.near_depth = 4;
    answer(t.reference, 6, 4, 0, 5.625);
    BoundedPrecision precision{.eps_px = 0.168, .depth_relative = 1e-9, .watertight = false};
    const auto class_by = [&](const BoundedPrecision& declared) {
        t.candidate_precision = declared;
        return t.class_at(6, 4);
    };
    EXPECT_TRUE(passes(class_by(precision)));
    precision.eps_px = 0.165;
    EXPECT_EQ(class_by(precision), PixelClass::hole);
    precision = {.eps_px = 0.168, .depth_relative = 1e-9};
    EXPECT_EQ(class_by(precision), PixelClass::hole) << "a watertight one has no gap";
}

/// What near leaves moves as a whole: its cut lies 1/2 px beside the centre of pixel (0, 0).
TEST(HeldToThePromise, TheCutOfNearMovesWithWhatItLeaves) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 2}, {16, -8, 8}, {16, 24, 8}}}});
    t.view.camera.near_depth = 4;
    answer(t.reference, 0, 0, 0, 4.125);
    const auto class_by = [&](double eps_px) {
        t.candidate_precision =
            BoundedPrecision{.eps_px = eps_px, .depth_relative = 1e-9, .watertight = false};
        return t.class_at(0, 0);
    };
    EXPECT_EQ(class_by(0.51), PixelClass::clip);
    EXPECT_EQ(class_by(0.49), PixelClass::hole);
}

/// Far may cut the edge between two corners anywhere, and so a diagonal may pass the centre of pixel (6, 4).
TEST(HeldToThePromise, ADiagonalMayEndWhereverFarMayCutBetweenTwoCorners) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 2}, {16, -8, 8.001}, {16, 24, 7.999}}}});
    answer(t.reference, 6, 4, 0, 5.624823);
    t.reference_precision = BoundedPrecision{.eps_px = 1e-6, .depth_relative = 1e-6};
    const auto class_by = [&](double far_depth) {
        t.view.camera.far_depth = far_depth;
        t.candidate_precision = BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-3, .watertight = false};
        return t.class_at(6, 4);
    };
    EXPECT_TRUE(passes(class_by(8)));
    EXPECT_EQ(class_by(8.1), PixelClass::hole) << "far reaches no corner";
}

/// A needle in line with the centre of pixel (5, 1), 3 px beyond its tip: all edge functions err by more than
/// its width.
TEST(HeldToThePromise, RoundedEdgeFunctionsShowATriangleBeyondItsTip) {
    const double thin = 1e-6;
    TestScene t(Projection::parallel, 8, 4, {{{{-40, 1.5, 4}, {2.5, 1.5, 4}, {-40, 1.5 + thin, 4}}}});
    t.candidate_precision = RasterPrecision{.snap = Snap::none, .edge_functions = EdgeFunctions::from_corner};
    EXPECT_EQ(class_of_depth(t, 5, 1, 4), PixelClass::edge);
    EXPECT_EQ(class_of_depth(t, 5, 2, 4), PixelClass::outside) << "beside the line";
    t.candidate_precision = RasterPrecision{.snap = Snap::none};
    EXPECT_EQ(class_of_depth(t, 5, 1, 4), PixelClass::outside) << "exact edge functions say so";
}

/// Two weights of minus the tolerance lie 85 of it in px beyond the tip; the pixel's centre lies 1 px there.
TEST(HeldToThePromise, AWeightsToleranceShowsATriangleBeyondItsTip) {
    TestScene t(Projection::parallel, 8, 4, {{{{-40, 1.4, 4}, {2.5, 1.5, 4}, {-40, 1.6, 4}}}});
    const auto class_by = [&](double tolerance) {
        t.candidate_precision =
            RayPrecision{.arithmetic = Arithmetic::float64, .barycentric_tolerance = tolerance};
        return class_of_depth(t, 3, 1, 4);
    };
    EXPECT_EQ(class_by(1.01 / 85), PixelClass::edge);
    EXPECT_EQ(class_by(0.99 / 85), PixelClass::outside);
}

TriangleBounds bounds_by(const TestScene& t, const Precision& precision) {
    return ViewBounds(t.view, precision).of(corners_of(t.scene, 0));
}

/// Corners (0, 0, 4), (8, 0, 4) and (0, 4, 4): their coordinates add up to 4, 12 and 8, those of directions
/// to 4 + 2 + 1 at most. The volume is 4 x 32, and no side is longer than 8 along an axis.
TEST(HeldToThePromise, WoopsDistanceErrsAsItsWeightsDo) {
    const TestScene t(Projection::perspective, 4, 2, {{{{0, 0, 4}, {2, 0, 4}, {0, 1, 4}}}});
    const double added = bounds_by(t, RayPrecision{.test = RayTest::woop}).depth_factor -
                         bounds_by(t, RayPrecision{.test = RayTest::pluecker}).depth_factor;
    EXPECT_NEAR(added / gamma(10, unit_roundoff_float32),
                2 * (4 * 12 + 12 * 8 + 8 * 4) * 7 * std::sqrt(3.0) * 8 / 128, 1e-6);
}

/// Each corner may move by half of what the triangle is high: nothing is left of it.
TEST(HeldToThePromise, CornersThatMayMoveTogetherLeaveThePlaneUnknown) {
    const TestScene t(Projection::perspective, 4, 2, {{{{0, 0, 4}, {2, 0, 4}, {0, 1, 4}}}});
    const auto factor_by = [&](double world_absolute) {
        return bounds_by(t, RayPrecision{.arithmetic = Arithmetic::float64, .world_absolute = world_absolute})
            .depth_factor;
    };
    EXPECT_GT(factor_by(0.04), factor_by(0));
    EXPECT_LT(factor_by(0.04), 1e-6);
    EXPECT_EQ(factor_by(2), unlimited);
}

/// Near at a corner, but for rounding, leaves a tip or none of it.
TEST(HeldToThePromise, WeightsOfAPieceThatMayVanishTellNoDepth) {
    const RasterPrecision precision{.snap = Snap::none, .edge_functions = EdgeFunctions::from_corner};
    const auto depth_factor = [&](double nearest) {
        TestScene t(Projection::perspective, 4, 2, {{{{0, 0, nearest}, {2, 0, 8}, {0, 1, 8}}}});
        t.view.camera.near_depth = 4;
        return bounds_by(t, precision).depth_factor;
    };
    EXPECT_EQ(depth_factor(4), unlimited);
    EXPECT_LT(depth_factor(4 + 1e-4), 1e-5);
    EXPECT_LT(depth_factor(4 - 1e-1), 1e-5) << "what is cut off has an area";
}

}  // namespace
}  // namespace zproof
