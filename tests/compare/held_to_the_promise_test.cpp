/// Depths and gaps at the limit of what is promised, and a hundredth beyond it.
#include <gtest/gtest.h>

#include <cmath>

#include "frame/frame_error.h"
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

/// A reference that breaks its own promise at a pixel proves nothing there.
TEST(HeldToThePromise, AReferenceWhoseOwnDepthIsWrongDoesNotProveItsId) {
    TestScene t(Projection::perspective, 2, 2, {wall(4), wall(8)});
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-3, .depth_relative = 0.1};
    t.reference_precision = BoundedPrecision{.eps_px = 1e-3, .depth_relative = 1e-6};
    answer_everywhere(t.candidate, 1, 8);
    answer_everywhere(t.reference, 1, 8.1);
    EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden);
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

/// A step is of what is shown. The reference takes the wall behind for the nearer one, as it may by 1e-6; its
/// depth is none that a finer renderer compares, and proves nothing to it.
TEST(HeldToThePromise, DepthsInStepsAreNotProvenByAReferenceThatErsFarther) {
    const auto class_by = [](double share, std::uint32_t shown) {
        TestScene t(Projection::perspective, 2, 2, {wall(4), wall(4 * (1 + 0x1p-21))});
        t.reference_precision = BoundedPrecision{.eps_px = 1e-9, .depth_relative = 1e-6};
        t.candidate_precision =
            BoundedPrecision{.eps_px = 1e-9, .depth_relative = share, .depth_step = 0.125};
        answer_everywhere(t.reference, shown, 4 * (1 + 0x1p-20));
        answer_everywhere(t.candidate, shown, 4);
        return t.class_at(0, 0);
    };
    EXPECT_EQ(class_by(1e-8, 1), PixelClass::hidden);
    EXPECT_EQ(class_by(1e-8, 0), PixelClass::agree);
    EXPECT_TRUE(passes(class_by(1e-6, 1)));
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

/// A plane in float32 that has next to no area leads anywhere; in a parallel view, behind the eye.
TEST(HeldToThePromise, ADepthThatNothingBoundsMayLieBehindAParallelEye) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, 3.5, 4}, {16, 3.5, 8}, {-8, 3.5 + 1e-3, 4}}}});
    t.candidate_precision = RasterPrecision{.depth_interpolation = DepthInterpolation::plane};
    answer(t.candidate, 4, 3, 0, -50);
    EXPECT_TRUE(passes(t.class_at(4, 3)));
    EXPECT_EQ(t.verdict().open_depths, 1u);
    t.candidate_precision = RasterPrecision{};
    EXPECT_EQ(t.class_at(4, 3), PixelClass::invalid);
    EXPECT_EQ(t.verdict().open_depths, 0u);
}

/// Both triangles may end just where the centre lies, and hold it no more.
TEST(HeldToThePromise, AnEdgeThatIsMovedOntoTheCentreLeavesItBare) {
    TestScene t(Projection::parallel, 4, 16, {wall_left_of(1.75, 4), wall_right_of(1.75, 4)});
    answer(t.reference, 1, 8, 0, 4);
    const auto class_by = [&](double eps_px) {
        t.candidate_precision =
            BoundedPrecision{.eps_px = eps_px, .depth_relative = 1e-9, .watertight = false};
        return t.class_at(1, 8);
    };
    EXPECT_TRUE(passes(class_by(0.25)));
    EXPECT_EQ(class_by(0.2499), PixelClass::hole);
}

/// Two float32 numbers are told: a depth of 4 is off by 2 u of it, or by 4.
TEST(HeldToThePromise, ARaysDepthIsRoundedAsOftenAsDeclared) {
    TestScene t(Projection::parallel, 2, 2, {wall(4)});
    answer_everywhere(t.reference, 0, 4);
    const auto class_by = [&](int roundings, double depth) {
        t.candidate_precision = RayPrecision{.arithmetic = Arithmetic::float64, .depth_roundings = roundings};
        return class_of_depth(t, 0, 0, depth);
    };
    EXPECT_EQ(class_by(1, 4 + 0x1p-21), PixelClass::wrong_depth);
    EXPECT_EQ(class_by(2, 4 + 0x1p-21), PixelClass::agree);
    EXPECT_EQ(class_by(3, 4 + 0x1p-20), PixelClass::wrong_depth);
    EXPECT_EQ(class_by(4, 4 + 0x1p-20), PixelClass::agree);
}

/// A share of an infinite range is no bound.
TEST(HeldToThePromise, AShareOfTheRangeNeedsAFarPlane) {
    TestScene t(Projection::perspective, 2, 2, {wall(4)});
    const BoundedPrecision of_range{.eps_px = 0.01, .depth_relative = 1e-6, .depth_of_range = 1e-9};
    for (const Precision& declared : {Precision(of_range), Precision(RayPrecision{.depth_of_range = 1e-9}),
                                      Precision(PlaneRayPrecision{.depth_of_range = 1e-9})}) {
        t.view.camera.far_depth = 100;
        t.candidate_precision = declared;
        EXPECT_EQ(t.class_at(0, 0), PixelClass::hole);
        t.view.camera.far_depth = HUGE_VAL;
        EXPECT_THROW(t.verdict(), FrameError);
    }
}

/// What is moved to beyond near is moved in the image by its own depth, which is less than near's.
TEST(HeldToThePromise, AWorldErrorCountsByTheDepthBeforeNear) {
    constexpr double depth = 0.2, world_absolute = 0.1;
    const RayPrecision precision{.arithmetic = Arithmetic::float64, .world_absolute = world_absolute};
    const auto class_at = [&](double share) {
        TestScene t(Projection::perspective, 2, 2, {wall_left_of(0, depth)});
        t.candidate_precision = precision;
        const double moved_px =
            ViewBounds(t.view, precision).of(corners_of(t.scene, 0)).eps_per_inverse_depth / depth;
        t.scene = scene_of(t.view, {wall_left_of(1.5 - share * moved_px, depth)});
        return class_of_depth(t, 1, 1, 0.28);
    };
    EXPECT_TRUE(passes(class_at(0.99)));
    EXPECT_EQ(class_at(1.01), PixelClass::outside);
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

/// What near leaves moves as a whole: its cut lies 1/2 px beside the centre of pixel (3, 4).
TEST(HeldToThePromise, TheCutOfNearMovesWithWhatItLeaves) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 2}, {40, -8, 14}, {-8, 40, 2}}}});
    t.view.camera.near_depth = 4.75;
    answer(t.reference, 3, 4, 0, 4.875);
    const auto class_by = [&](double eps_px) {
        t.candidate_precision =
            BoundedPrecision{.eps_px = eps_px, .depth_relative = 1e-9, .watertight = false};
        return t.class_at(3, 4);
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

/// The image's sides leave a pentagon of the triangle. Where the right one meets the upper one a diagonal
/// begins that passes 1/2 px beside the centre of pixel (6, 4), and at 0.261 px where the sides cut within
/// that.
TEST(HeldToThePromise, ATriangleThatTheSidesCutHasAGapAlongADiagonal) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 4}, {16, -8, 4}, {16, 24, 4}}}});
    answer(t.reference, 6, 4, 0, 4);
    const auto class_by = [&](const RasterPrecision& declared) {
        t.candidate_precision = declared;
        return t.class_at(6, 4);
    };
    constexpr RasterPrecision coarse{
        .subpixel_bits = 0, .watertight = false, .clipping = Clipping::view_volume};
    EXPECT_TRUE(passes(class_by(coarse)));
    RasterPrecision other = coarse;
    other.subpixel_bits = 1;
    EXPECT_EQ(class_by(other), PixelClass::hole) << "corners move by 1/4 px";
    other = coarse;
    other.clipping = Clipping::guard_band;
    EXPECT_EQ(class_by(other), PixelClass::hole) << "it lies within the guard band";
    other = coarse;
    other.watertight = true;
    EXPECT_EQ(class_by(other), PixelClass::hole) << "a watertight one has no gap";
}

/// Whichever side cuts a little of its corner there, what is left has diagonals beside its edges. Along a
/// side its edge may be cut anywhere.
TEST(HeldToThePromise, ATriangleWithCornersOnTheSidesHasNoGapWithin) {
    TestScene t(Projection::parallel, 8, 8, {{{{0, 2, 4}, {8, 3, 4}, {3, 8, 4}}}}),
        along(Projection::parallel, 8, 8, {{{{0, 0, 4}, {8, 0, 4}, {8, 8, 4}}}});
    for (TestScene* scene : {&t, &along}) {
        answer(scene->reference, 5, 4, 0, 4);
        scene->candidate_precision = RasterPrecision{.watertight = false, .clipping = Clipping::view_volume};
    }
    EXPECT_EQ(t.class_at(5, 4), PixelClass::hole);
    EXPECT_TRUE(passes(along.class_at(5, 4)));
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

/// Embree may show it there. That proves nothing to one that displaces it by a thousandth of a pixel.
TEST(HeldToThePromise, ATipThatTheReferenceShowsByRoundingProvesNothing) {
    const double thin = 1e-6;
    TestScene t(Projection::parallel, 8, 4, {{{{-40, 1.5, 4}, {2.5, 1.5, 4}, {-40, 1.5 + thin, 4}}}});
    answer(t.candidate, 5, 1, 0, 4);
    answer(t.reference, 5, 1, 0, 4);
    answer(t.reference, 0, 3, 0, 4);  // or both are one frame
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-3, .depth_relative = 1e-6};
    EXPECT_EQ(t.class_at(5, 1), PixelClass::outside);
    t.candidate_precision = ray_precision();
    EXPECT_TRUE(passes(t.class_at(5, 1)));
}

/// Edges that err show nothing that near or far cuts off.
TEST(HeldToThePromise, RoundedEdgesShowNothingBeyondThePlanes) {
    for (const Projection projection : {Projection::perspective, Projection::parallel})
        for (const Precision& precision :
             {ray_precision(), Precision{RasterPrecision{.edge_functions = EdgeFunctions::from_corner}},
              Precision{RasterPrecision{.snap = Snap::none, .edge_functions = EdgeFunctions::homogeneous}},
              Precision{RayPrecision{.arithmetic = Arithmetic::float64, .barycentric_tolerance = 1e-3}}})
            for (const double depth : {0.5, 16.0}) {
                TestScene t(projection, 4, 4, {wall(depth)});
                t.view.camera.near_depth = 1, t.view.camera.far_depth = 8;
                t.candidate_precision = precision;
                EXPECT_EQ(class_of_depth(t, 1, 1, depth), PixelClass::outside) << depth;
                t.view.camera.near_depth = 0.25, t.view.camera.far_depth = 32;
                answer(t.reference, 1, 1, 0, depth);
                EXPECT_TRUE(passes(class_of_depth(t, 1, 1, depth))) << depth;
            }
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

/// A rasterizer's weights are those of the image, whatever the corners' depths.
TEST(HeldToThePromise, AWeightOfTheImageIsHeldToItsTolerance) {
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        TestScene t(projection, 8, 4, {{{{-40, 1.4, 4}, {2.5, 1.5, 64}, {-40, 1.6, 4}}}});
        const auto class_by = [&](double tolerance) {
            t.candidate_precision = RasterPrecision{.transform = Arithmetic::float64,
                                                    .snap = Snap::none,
                                                    .edge_functions = EdgeFunctions::from_corner,
                                                    .edge_arithmetic = Arithmetic::float64,
                                                    .barycentric_tolerance = tolerance};
            return class_of_depth(t, 3, 1, 64);
        };
        EXPECT_NE(class_by(1.01 / 85), PixelClass::outside);
        EXPECT_EQ(class_by(0.99 / 85), PixelClass::outside);
    }
}

TriangleBounds bounds_by(const TestScene& t, const Precision& precision) {
    return ViewBounds(t.view, precision).of(corners_of(t.scene, 0));
}

/// A depth of 1.25 is told as 1, and one of 1 as 1.3: t - r t - a >= near, t + r t + a <= far.
TEST(HeldToThePromise, DepthsThatErrAreHeldAgainstThePlanes) {
    TestScene t(Projection::perspective, 8, 8, {wall(4)});
    t.view.camera.near_depth = 1;
    const TriangleBounds bounds =
        bounds_by(t, BoundedPrecision{.eps_px = 1, .depth_relative = 0.2, .depth_absolute = 0.1});
    EXPECT_NEAR(bounds.near_slack, (1 + 0.1) / (1 - 0.2) - 1, 1e-12);
    EXPECT_NEAR(bounds.far_slack, (1024 + 0.1) / (1 - 0.2) - 1024, 1e-9);
}

/// Three weights down to minus the tolerance: 6 of it more in absolute values. In space a corner at depth 1
/// counts as often as the pixel is deep. A place that two weights leave moves by 4 times the tolerance more.
TEST(HeldToThePromise, WeightsBelow0CountByTheirCornersDepths) {
    const TestScene t(Projection::perspective, 8, 8, {{{{0, 0, 1}, {8, 0, 1}, {4, 8, 64}}}});
    const double tolerance = 1e-3, negative = 6 * tolerance, nearest = 1;
    RasterPrecision precision{.transform = Arithmetic::float32,
                              .edge_functions = EdgeFunctions::from_corner,
                              .edge_arithmetic = Arithmetic::float64,
                              .interpolation = Arithmetic::float32,
                              .depth_roundings = 2};
    const TriangleBounds without = bounds_by(t, precision);
    precision.barycentric_tolerance = tolerance;
    const TriangleBounds with = bounds_by(t, precision);
    const auto expect_more = [](double more, double less, double by) {
        EXPECT_NEAR((more - less) / by, 1, 1e-6);
    };
    const double u = unit_roundoff_float32, drift = without.eps_base_px + without.eps_per_inverse_depth;
    expect_more(with.inverse_depth_error, without.inverse_depth_error,
                negative * (gamma(2, u) + gamma(8, u)) / nearest);
    expect_more(with.depth_factor, without.depth_factor, negative * without.depth_absolute / nearest);
    expect_more(with.depth_eps_base_px, without.depth_eps_base_px,
                negative * (without.depth_eps_base_px + without.depth_eps_per_inverse_depth / nearest));
    expect_more(with.eps_base_px, without.eps_base_px, tolerance * (8 + 4 * drift));
}

/// Corners (0, 0, 4), (8, 0, 4) and (0, 4, 4): their coordinates add up to 4, 12 and 8, those of directions
/// to 4 + 2 + 1 at most. The volume is 4 x 32, and no side is longer than 8 along an axis.
TEST(HeldToThePromise, WoopsDistanceErrsAsItsWeightsDo) {
    const TestScene t(Projection::perspective, 4, 2, {{{{0, 0, 4}, {2, 0, 4}, {0, 1, 4}}}});
    const double added = bounds_by(t, RayPrecision{.test = RayTest::woop}).depth_factor -
                         bounds_by(t, RayPrecision{.test = RayTest::pluecker}).depth_factor;
    const double share = gamma(10, unit_roundoff_float32) * 2 * (4 * 12 + 12 * 8 + 8 * 4) * 7 / 128;
    EXPECT_NEAR(added / (share * std::sqrt(3.0) * 8 * (1 + compounded(4 * share))), 1, 1e-9);
}

/// Corners (0, 0, 4), (16, 0, 8) and (0, 4, 4), directions of (4, 2, 1) at most, a volume of 256. The
/// products of differences and sums come to 512, 896 and 128; those of Moeller and Trumbore to 128, 64 and
/// 128.
TEST(HeldToThePromise, AHitOfWeightsErrsAsTheyDo) {
    const TestScene t(Projection::perspective, 4, 2, {{{{0, 0, 4}, {2, 0, 8}, {0, 1, 4}}}});
    const auto expect_added = [&](RayTest test, double weights, double range) {
        const double share = weights / 256,
                     added = bounds_by(t, {RayPrecision{.test = test, .hit_point = HitPoint::barycentrics}})
                                 .depth_factor -
                             bounds_by(t, RayPrecision{.test = test}).depth_factor;
        EXPECT_NEAR(added / (share * range * (1 + compounded(8 * share))), 1, 1e-9) << int(test);
    };
    const double u = unit_roundoff_float32, depths = 8 - 4, distances = std::sqrt(3.0) * 16;
    expect_added(RayTest::pluecker, gamma(7, u) * (512 + 896 + 128) / 2, depths);
    expect_added(RayTest::moeller_trumbore, 2 * gamma(10, u) * (128 + 64 + 128), depths);
    expect_added(RayTest::woop, gamma(10, u) * 2 * (4 * 24 + 24 * 8 + 8 * 4) * 7, depths - distances);
    const TestScene wall(Projection::perspective, 4, 2, {{{{0, 0, 4}, {2, 0, 4}, {0, 1, 4}}}});
    EXPECT_EQ(bounds_by(wall, RayPrecision{.hit_point = HitPoint::barycentrics}).depth_factor,
              bounds_by(wall, RayPrecision{}).depth_factor)
        << "all corners have its depth";
}

/// Twice the area is 1 px^2: a product of any two of its sides, within 8 roundings of each.
TEST(HeldToThePromise, ALeastDeterminantIsHeldAgainstARoundedOne) {
    const TestScene t(Projection::parallel, 4, 2, {{{{0, 0, 4}, {1, 0, 4}, {0, 1, 4}}}});
    const auto may_be_missing = [&](double least) {
        return bounds_by(t, RayPrecision{.least_determinant = least}).may_be_missing;
    };
    const double rounding = 3 * gamma(8, unit_roundoff_float32);
    EXPECT_TRUE(may_be_missing(1 - 0.99 * rounding));
    EXPECT_FALSE(may_be_missing(1 - 1.01 * rounding));
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
