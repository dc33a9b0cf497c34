/// Every key of a declaration from both sides: what uses nearly all of its allowance passes, 1.1 times of it
/// fails. Allowances are worked out here by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/bounds/z_range.h"
#include "math/rounding.h"
#include "test_scene.h"

namespace zproof {
namespace {

using enum Projection;

constexpr double u = unit_roundoff_float32;
constexpr double nearly = 0.98, beyond = 1.1;

/// Arithmetic so fine that a single key decides.
RasterPrecision fine_raster() {
    return {.transform = Arithmetic::float64,
            .subpixel_bits = 16,
            .interpolation = Arithmetic::float64,
            .depth_roundings = 1};
}
RayPrecision fine_ray() { return {.arithmetic = Arithmetic::float64}; }

/// A wall that everybody names at its only pixel, at this depth but for an error.
bool passes_with_depth(Projection projection, const Precision& precision, double depth, double error) {
    TestScene t(projection, 1, 1, {wall(depth)});
    t.candidate_precision = precision;
    answer(t.reference, 0, 0, 0, depth);
    answer(t.candidate, 0, 0, 0, depth + error);
    return passes(t.class_at(0, 0));
}

void expect_depth_allowance(Projection projection, const Precision& precision, double depth,
                            double allowance) {
    EXPECT_TRUE(passes_with_depth(projection, precision, depth, nearly * allowance));
    EXPECT_TRUE(passes_with_depth(projection, precision, depth, -nearly * allowance));
    EXPECT_FALSE(passes_with_depth(projection, precision, depth, beyond * allowance));
    EXPECT_FALSE(passes_with_depth(projection, precision, depth, -beyond * allowance));
}

/// A near wall ends this far left of pixel 2's centre, which the candidate still shows it at.
bool passes_displaced(const Precision& precision, double displacement_px) {
    TestScene t(parallel, 4, 1, {wall_left_of(2.5 - displacement_px, 4), wall(8)});
    t.candidate_precision = precision;
    answer_everywhere(t.reference, 1, 8);
    answer_everywhere(t.candidate, 0, 4);
    return passes(t.class_at(2, 0));
}

void expect_displacement_allowance(const Precision& precision, double allowance_px) {
    EXPECT_TRUE(passes_displaced(precision, nearly * allowance_px));
    EXPECT_FALSE(passes_displaced(precision, beyond * allowance_px));
}

TEST(BoundedPrecision, AllowsItsDisplacementAndNoMore) {
    expect_displacement_allowance(BoundedPrecision{.eps_px = 0.0625}, 0.0625);
}

TEST(BoundedPrecision, AllowsItsDepthErrorsAndNoMore) {
    const double tiny = 1e-9;
    for (const Projection projection : {perspective, parallel}) {
        expect_depth_allowance(projection, BoundedPrecision{.eps_px = tiny, .depth_relative = 1e-3}, 4, 4e-3);
        expect_depth_allowance(projection, BoundedPrecision{.eps_px = tiny, .depth_absolute = 0.01}, 4, 0.01);
        const double range = projection == perspective ? 1024 - 0.25 : 64 - 0.25;
        expect_depth_allowance(projection, BoundedPrecision{.eps_px = tiny, .depth_of_range = 1e-5}, 4,
                               1e-5 * range);
    }
}

/// `fine` with reported depths in steps.
template <class Kind>
Precision in_steps(Kind fine, double depth_step) {
    fine.depth_step = depth_step;
    return fine;
}

TEST(DepthStep, AllowsHalfAStepAndNoMoreWhateverElseIsPromised) {
    for (const Projection projection : {perspective, parallel})
        for (const Precision& precision :
             {in_steps(fine_raster(), 0.02), in_steps(RayPrecision{}, 0.02),
              in_steps(PlaneRayPrecision{}, 0.02), in_steps(BoundedPrecision{.eps_px = 1e-9}, 0.02)})
            expect_depth_allowance(projection, precision, 4, 0.01);
    const BoundedPrecision both{.eps_px = 1e-9, .depth_relative = 1e-3, .depth_absolute = 0.01};
    expect_depth_allowance(perspective, in_steps(both, 0.02), 4, 4e-3 + 0.02);
}

/// What is rounded to a step is rounded to float32 then, on top of whatever else it errs by.
TEST(DepthStep, CompoundsTheRoundingToFloat32) {
    const View view = pixel_view(perspective, 1, 1);
    const BoundedPrecision both{.eps_px = 1e-9, .depth_relative = 1e-3, .depth_absolute = 0.01};
    const TriangleBounds of_wall =
        ViewBounds::of_shown(view, in_steps(both, 0.02)).of(corners_of(scene_of(view, {wall(64)}), 0));
    const LocalBounds shown = BoundsOnPlane(of_wall, 0).at(1.0 / 64);
    EXPECT_DOUBLE_EQ(shown.depth_relative, compounded(u) + 1e-3 * (1 + u));
    EXPECT_DOUBLE_EQ(shown.depth_absolute, 0.02 * (1 + u));
}

/// Depth is rounded when it is reported, after it was compared.
TEST(DepthStep, HidesNoTriangleBehindAnother) {
    for (const Projection projection : {perspective, parallel}) {
        TestScene t(projection, 1, 1, {wall(4), wall(4.004)});
        t.candidate_precision = in_steps(fine_raster(), 0.02);
        answer(t.reference, 0, 0, 0, 4);
        for (const float shown : {4.0f, 4.004f}) {
            answer(t.candidate, 0, 0, 1, shown);
            EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden);
            answer(t.candidate, 0, 0, 0, shown);
            EXPECT_TRUE(passes(t.class_at(0, 0)));
        }
    }
}

TEST(DepthStep, LeavesOpenWhatWasComparedWithinHalfAStep) {
    const View view = pixel_view(perspective, 1, 1);
    const InverseDepthRange compared = ViewBounds(view, in_steps(RayPrecision{}, 0.02)).compared_at(4);
    for (const double depth : {3.99, 4.01})
        EXPECT_TRUE(compared.least <= 1 / depth && 1 / depth <= compared.greatest) << depth;
    EXPECT_LT(compared.greatest, 1 / 3.9899);
    EXPECT_GT(compared.least, 1 / 4.0101);
}

RasterPrecision with_buffer(DepthBuffer buffer, DepthFormat format) {
    RasterPrecision p = fine_raster();
    p.depth_buffer = buffer;
    p.depth_format = format;
    return p;
}

TEST(DepthFormat, AllowsOneStepOfTheBuffer) {
    const double step = 1 / 65535.0;
    for (const DepthBuffer buffer : {DepthBuffer::standard_z, DepthBuffer::reversed_z}) {
        const RasterPrecision p = with_buffer(buffer, DepthFormat::unorm16);
        expect_depth_allowance(parallel, p, 4, step * 63.75);
        expect_depth_allowance(perspective, p, 4, 4 * 4 * step / 0.25);
    }
    EXPECT_EQ(step_of_z(DepthFormat::unorm24), 1 / 16777215.0);
    EXPECT_EQ(step_of_z(DepthFormat::unorm32), 1 / 4294967295.0);
}

/// Beside a step of 16 bits, what float32 does to z is a sixteenth at most.
TEST(DepthRounding, NearestIsHalfAStepAndTruncationOneStepOfZDownwards) {
    const double step = 63.75 / 65535;
    for (const DepthBuffer buffer : {DepthBuffer::standard_z, DepthBuffer::reversed_z}) {
        RasterPrecision p = with_buffer(buffer, DepthFormat::unorm16);
        p.depth_rounding = DepthRounding::nearest;
        expect_depth_allowance(parallel, p, 4, step / 2);
        p.depth_rounding = DepthRounding::truncate;
        const double nearer = buffer == DepthBuffer::standard_z ? -1 : 1;
        EXPECT_TRUE(passes_with_depth(parallel, p, 4, nearer * nearly * step));
        EXPECT_FALSE(passes_with_depth(parallel, p, 4, nearer * beyond * step));
        EXPECT_TRUE(passes_with_depth(parallel, p, 4, 0));
        EXPECT_FALSE(passes_with_depth(parallel, p, 4, -nearer * step / 16));
    }
}

/// Two walls closer together than a step: which is drawn in front depends on whether their steps differ.
TEST(DepthRounding, DecidesWhichDepthsAreTold) {
    const double step = 63.75 / 65535;
    TestScene t(parallel, 1, 1, {wall(4), wall(4 + 1.5 * step)});
    answer(t.reference, 0, 0, 0, 4);
    answer(t.candidate, 0, 0, 1, 4 + 1.5 * step);
    RasterPrecision p = with_buffer(DepthBuffer::standard_z, DepthFormat::unorm16);
    t.candidate_precision = p;
    EXPECT_EQ(t.class_at(0, 0), PixelClass::wrong_depth) << "the wall is a step farther at most";
    for (const double steps : {0.51, 0.99}) {
        answer(t.candidate, 0, 0, 1, 4 + steps * step);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::depth_tie) << "either step may be taken";
    }
    answer(t.candidate, 0, 0, 1, 4 + 1.01 * step);
    EXPECT_EQ(t.class_at(0, 0), PixelClass::wrong_depth);
    for (const DepthRounding rounding : {DepthRounding::nearest, DepthRounding::truncate}) {
        p.depth_rounding = rounding;
        t.candidate_precision = p;
        EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden);
    }
}

/// z times the number of steps is rounded once, and once more with the 1/2 that finds the nearest.
TEST(DepthRounding, ScalingInFloat32CountsAt24Bits) {
    RasterPrecision p = with_buffer(DepthBuffer::standard_z, DepthFormat::unorm24);
    const double step = 1 / 16777215.0;
    p.depth_rounding = DepthRounding::truncate;
    EXPECT_DOUBLE_EQ(quantization(p, 1, u).error, step / 2 + gamma(1, u));
    EXPECT_EQ(quantization(p, 1, u).bias, -step / 2);
    p.depth_rounding = DepthRounding::nearest;
    EXPECT_DOUBLE_EQ(quantization(p, 1, u).error, step / 2 + gamma(2, u) * (1 + step));
    EXPECT_EQ(quantization(p, 1, u).bias, 0);
    p.depth_rounding = DepthRounding::either;
    EXPECT_EQ(quantization(p, 1, u).error, step);
}

/// With near at 1/4 and a wall at 64, z is 1 - 1/256: corners' 4 roundings, 8 of the mean, 6 of the way back.
TEST(DepthFormat, Float64KeepsZAsTheTransformHasIt) {
    RasterPrecision p = with_buffer(DepthBuffer::standard_z, DepthFormat::float64);
    p.depth_interpolation = DepthInterpolation::barycentrics;
    p.matrix_far = MatrixFar::infinite;
    const View view = pixel_view(perspective, 1, 1);
    const Scene scene = scene_of(view, {wall(64)});
    const auto error = [&](const RasterPrecision& one) {
        return ViewBounds(view, one).of(corners_of(scene, 0)).inverse_depth_error * 0.25;
    };
    const double z = 1 - 1 / 256.0, v = unit_roundoff_float64;
    EXPECT_NEAR(error(p), gamma(12, v) * z + gamma(6, v) * (1 + z), 1e-3 * v);
    p.linearization = Arithmetic::float32;
    EXPECT_NEAR(error(p), gamma(6, u) * (1 + z), 1e-3 * u);
    p.linearization = Arithmetic::float64;
    p.transform = Arithmetic::float32;
    EXPECT_NEAR(error(p), gamma(4, u) * z, 1e-3 * u);
    p.transform = Arithmetic::float64;
    EXPECT_FALSE(passes_with_depth(perspective, p, 64, 2 * u * 64)) << "only the frame's rounding is left";
    p.depth_format = DepthFormat::float32;
    EXPECT_TRUE(passes_with_depth(perspective, p, 64, 2 * u * 64));
}

/// At depth 64 with near at 1/4, z is 1 - 1/256: rounding it costs 256 times what rounding 1/256 costs.
TEST(DepthBuffer, StandardZAllowsErrorsThatGrowWithDepthSquaredOverNear) {
    const double z = 1 - 1 / 256.0, allowance = gamma(4, u) * z * 64 * 64 / 0.25;
    const RasterPrecision standard = with_buffer(DepthBuffer::standard_z, DepthFormat::float32),
                          reversed = with_buffer(DepthBuffer::reversed_z, DepthFormat::float32);
    expect_depth_allowance(perspective, standard, 64, allowance);
    EXPECT_FALSE(passes_with_depth(perspective, reversed, 64, nearly * allowance));
    const double least = gamma(5, u) * 64;  // of z, and of the depth in the frame
    EXPECT_TRUE(passes_with_depth(perspective, reversed, 64, 0.7 * least));
    EXPECT_FALSE(passes_with_depth(perspective, reversed, 64, 1.3 * least));
}

TEST(ClipRange, AViewportThatAddsOneHalfRoundsSmallZAsIfItWereOne) {
    RasterPrecision p = with_buffer(DepthBuffer::reversed_z, DepthFormat::float32);
    const double allowance = gamma(4, u) * 64 * 64 / 0.25;
    EXPECT_FALSE(passes_with_depth(perspective, p, 64, nearly * allowance));
    p.clip_range = ClipRange::minus_one_to_one;
    expect_depth_allowance(perspective, p, 64, allowance);
}

TEST(Linearization, InFloat32CostsSixRoundingsMore) {
    RasterPrecision p = with_buffer(DepthBuffer::standard_z, DepthFormat::float32);
    p.linearization = Arithmetic::float32;
    const double z = 1 - 1 / 256.0, allowance = (gamma(4, u) * z + gamma(6, u) * (1 + z)) * 64 * 64 / 0.25;
    expect_depth_allowance(perspective, p, 64, allowance);
}

/// The row of z of a finite standard z: its factor of depth is nearly 1, so that positions' size counts over
/// near.
TEST(MatrixFar, AFiniteFarMakesTheRowOfZCountOverNear) {
    RasterPrecision p = with_buffer(DepthBuffer::reversed_z, DepthFormat::float32);
    p.transform = Arithmetic::float32;
    p.clip_range = ClipRange::zero_to_one;
    const ViewBounds infinite(pixel_view(perspective, 1, 1), p);
    p.matrix_far = MatrixFar::finite;
    const View view = pixel_view(perspective, 1, 1);
    const ViewBounds finite(view, p);
    const Scene scene = scene_of(view, {wall(64)});
    const double row =
        finite.of(corners_of(scene, 0)).depth_factor - infinite.of(corners_of(scene, 0)).depth_factor;
    const double share = 1024 / 1023.75, factor = share - 1, offset = 0.25 * share;
    EXPECT_NEAR(row, gamma(5, u) * (factor * 64 + offset) / offset, 0.01 * row);
}

TEST(ShownDepth, AVaryingIsFinerThanTheBufferThatDecides) {
    RasterPrecision p = with_buffer(DepthBuffer::standard_z, DepthFormat::unorm16);
    p.shown_depth = ShownDepth::varying;
    const double step = 63.75 / 65535;
    EXPECT_FALSE(passes_with_depth(parallel, p, 4, step / 2));
    TestScene t(parallel, 1, 1, {wall(4), wall(4 + step)});
    answer(t.reference, 0, 0, 0, 4);
    answer(t.candidate, 0, 0, 1, 4 + step);
    t.candidate_precision = p;
    EXPECT_EQ(t.class_at(0, 0), PixelClass::depth_tie) << "the buffer cannot tell them apart";
    p.depth_format = DepthFormat::unorm32;
    t.candidate_precision = p;
    EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden);
}

TEST(DepthInterpolation, OnlyWeightsKeepToTheCorners) {
    const View view = pixel_view(parallel, 1, 1);
    RasterPrecision p;
    EXPECT_TRUE(ViewBounds(view, p).keeps_to_corners());
    p.depth_interpolation = DepthInterpolation::plane;
    EXPECT_FALSE(ViewBounds(view, p).keeps_to_corners());
}

/// Roundings are of the sizes of the near wall's corner at x = -512.
TEST(Matrices, EachRoundsFiveTimes) {
    RasterPrecision p{.subpixel_bits = 16};
    const double viewport = gamma(8, u) * 516, snap = 0x1p-17;
    for (const int matrices : {1, 2, 3}) {
        p.matrices = matrices;
        expect_displacement_allowance(p, snap + viewport + gamma(5 * matrices, u) * 512);
    }
}

TEST(Snap, NoneLeavesOnlyArithmetic) {
    RasterPrecision p{.snap = Snap::none};
    p.subpixel_bits = 0;
    expect_displacement_allowance(p, gamma(8, u) * 516 + gamma(5, u) * 512);
}

/// And the corner itself has one.
TEST(EdgeFunctions, FromACornerErrByFourRoundingsOfTheDistance) {
    RasterPrecision p{.snap = Snap::none, .edge_functions = EdgeFunctions::from_corner};
    p.transform = Arithmetic::float64;
    expect_displacement_allowance(p, (gamma(4, u) + u) * 516);
    p.edge_arithmetic = Arithmetic::float64;
    EXPECT_FALSE(passes_displaced(p, 1e-6));
}

/// a x + b y + c with 4 roundings of each term, of corners that are rounded once. Of the near wall's edges
/// the upper one errs most, from (2.5, -64) to (-512, 8).
TEST(EdgeFunctions, WindowCoefficientsErrByTheProductsOfCoordinates) {
    RasterPrecision p{.snap = Snap::none, .edge_functions = EdgeFunctions::window_coefficients};
    p.transform = Arithmetic::float64;
    const double width = 4, height = 1, c = 2.5 * 8 + 512 * 65;  // y = -64 is 65 rows from the lower side
    expect_displacement_allowance(p,
                                  gamma(4, u) * (72 * width + 514.5 * height + c) / (72 + 514.5) + u * 516);
    p.edge_arithmetic = Arithmetic::float64;
    EXPECT_FALSE(passes_displaced(p, 1e-6));
}

/// 1 - s - t, where s and t are edge functions over an area. On this wall a weight's error is worth its
/// height of 514.5 px before its vertical edge.
TEST(ThirdWeight, ARemainderErrsAsBothOthersDo) {
    RasterPrecision p{.snap = Snap::none,
                      .edge_functions = EdgeFunctions::from_corner,
                      .third_weight = ThirdWeight::remainder};
    p.transform = Arithmetic::float64;
    const double across = 514.5, down = 128, twice_area = across * down;
    const double of_edges = gamma(4, u) * 2 * 2 * across * down / twice_area,
                 of_quotients = gamma(4, u) + gamma(3, u);
    const double own = gamma(4, u) * 516;
    EXPECT_GT((of_edges + of_quotients) * twice_area / down, own);
    expect_displacement_allowance(p, (of_edges + of_quotients) * twice_area / down);
    EXPECT_FALSE(passes_displaced(RasterPrecision{.transform = Arithmetic::float64,
                                                  .snap = Snap::none,
                                                  .edge_functions = EdgeFunctions::from_corner},
                                  1.5 * own));
}

/// Weights that err alike, but for the third: it has the error of both others once more.
TEST(ThirdWeight, ARemainderBringsTheOthersErrorsIntoDepth) {
    RasterPrecision p{.snap = Snap::none, .edge_functions = EdgeFunctions::from_corner};
    const TestScene t(parallel, 1, 1, {wall(4)});
    const auto error = [&](ThirdWeight third) {
        p.third_weight = third;
        return ViewBounds(t.view, p).of(corners_of(t.scene, 0)).inverse_depth_error;
    };
    const double share = gamma(4, u) * 2 * 256 * 256 / (256 * 256);  // of one weight, and then of 4 units
    EXPECT_NEAR(error(ThirdWeight::edge_function), 3 * share * 4, 0.01 * share);
    EXPECT_NEAR(error(ThirdWeight::remainder), 2 * (2 * share + gamma(4, u) + gamma(3, u)) * 4, 0.01 * share);
}

/// The vertical edge from (x, -64) to (x, 64): |p0| x |p1| in absolute terms over its length.
TEST(EdgeFunctions, HomogeneousOnesErrBySixRoundingsOfAllProducts) {
    RasterPrecision p{.snap = Snap::none, .edge_functions = EdgeFunctions::homogeneous};
    p.transform = Arithmetic::float64;
    const TestScene t(parallel, 4, 1, {wall_left_of(2.5, 4), wall(8)});
    const ViewBounds exact(t.view, RasterPrecision{.transform = Arithmetic::float64, .snap = Snap::none}),
        rounded(t.view, p);
    const double own =
        rounded.of(corners_of(t.scene, 0)).eps_base_px - exact.of(corners_of(t.scene, 0)).eps_base_px;
    const double vertical = (128 * 4.0 + 5 * 1.0 + 2 * 2.5 * 64 * 1) / 128;  // by u, v and the constant
    EXPECT_GE(own, gamma(6, u) * vertical);
    EXPECT_LT(own, gamma(6, u) * 4 * 516) << "and not by much more than the triangle's reach";
}

/// The wall's height over its vertical edge is 514.5 px.
TEST(BarycentricTolerance, ReachesThatShareOfTheHeightBeyondTheEdge) {
    RasterPrecision raster = fine_raster();
    raster.barycentric_tolerance = 1e-4;
    expect_displacement_allowance(raster, 0.05145);
    RayPrecision ray = fine_ray();
    ray.barycentric_tolerance = 1e-4;
    expect_displacement_allowance(ray, 0.05145);
}

/// A triangle of 0.02 px^2 around the centre, before a wall that the candidate shows.
bool passes_without_small_one(const Precision& precision) {
    TestScene t(parallel, 1, 1, {{{{0.4, 0.4, 4}, {0.6, 0.4, 4}, {0.5, 0.6, 4}}}, wall(8)});
    t.candidate_precision = precision;
    answer(t.reference, 0, 0, 0, 4);
    answer(t.candidate, 0, 0, 1, 8);
    return passes(t.class_at(0, 0));
}

TEST(LeastArea, ATriangleBelowItMayBeMissing) {
    RasterPrecision p = fine_raster();
    p.least_area_px2 = 0.02 / nearly;
    EXPECT_TRUE(passes_without_small_one(p));
    p.least_area_px2 = 0.02 / beyond;
    EXPECT_FALSE(passes_without_small_one(p));
}

TEST(LeastDeterminant, ATriangleBelowItMayBeMissed) {
    RayPrecision p = fine_ray();
    p.least_determinant = 0.04 / nearly;
    EXPECT_TRUE(passes_without_small_one(p));
    p.least_determinant = 0.04 / beyond;
    EXPECT_FALSE(passes_without_small_one(p));
}

/// The wall has 256 * 256 / 2 px^2.
TEST(AreaEpsilon, ScalesDepthByItsShareOfTheArea) {
    RasterPrecision p = fine_raster();
    p.area_epsilon_px2 = 32.768;
    expect_depth_allowance(parallel, p, 4, 4e-3);
}

/// Two walls that share an edge 1/16 px right of pixel 2's centre, or below it, before a third.
bool passes_through_the_seam(const Precision& precision) {
    const auto passes_in = [&](TestScene t) {
        t.candidate_precision = precision;
        answer_everywhere(t.reference, 0, 4);
        answer_everywhere(t.candidate, 2, 8);
        return passes(t.class_at(2, 2));
    };
    const Triangle before = wall_left_of(2.5625, 4), after = wall_right_of(2.5625, 4);
    const bool beside = passes_in({parallel, 4, 4, {before, after, wall(8)}});
    EXPECT_EQ(passes_in({parallel, 4, 4, {transposed(before), transposed(after), wall(8)}}), beside);
    return beside;
}

TEST(Watertight, OnlyARendererThatLeavesGapsMayShowWhatLiesBehindASharedEdge) {
    const double wide = 0.0625 / nearly, narrow = 0.0625 / beyond;
    EXPECT_FALSE(passes_through_the_seam(BoundedPrecision{.eps_px = wide}));
    EXPECT_TRUE(passes_through_the_seam(BoundedPrecision{.eps_px = wide, .watertight = false}));
    EXPECT_FALSE(passes_through_the_seam(BoundedPrecision{.eps_px = narrow, .watertight = false}));
    EXPECT_TRUE(passes_through_the_seam(RayPrecision{.watertight = false, .aim_offset_px = wide}));
}

TEST(AimOffset, IsADisplacement) {
    RayPrecision p = fine_ray();
    p.aim_offset_px = 0.03;
    expect_displacement_allowance(p, 0.03);
}

TEST(WorldAbsolute, MovesCornersAndDepths) {
    RayPrecision p = fine_ray();
    p.world_absolute = 0.03;
    expect_displacement_allowance(p, 0.03);
    expect_depth_allowance(parallel, p, 4, 0.03);
}

TEST(DepthOfRange, IsAShareOfFarLessNear) {
    RayPrecision p = fine_ray();
    p.depth_of_range = 1e-4;
    expect_depth_allowance(parallel, p, 4, 1e-4 * (64 - 0.25));
    expect_depth_allowance(perspective, p, 4, 1e-4 * (1024 - 0.25));
    p.hit_point = HitPoint::barycentrics;
    expect_depth_allowance(parallel, p, 4, 1e-4 * (64 - 0.25));
}

/// A view from depth -8 on, in which a wall stands behind the eye and another before it.
TestScene around_the_eye(const RasterPrecision& precision, double first) {
    TestScene t(parallel, 1, 1, {wall(first), wall(4)});
    t.view.camera.near_depth = -8;
    t.candidate_precision = precision;
    answer(t.reference, 0, 0, 0, first);
    return t;
}

TEST(NothingBehindTheEye, WhatLiesThereIsMissingAndHidesNothing) {
    RasterPrecision ends = fine_raster(), whole = fine_raster();
    ends.nothing_behind_the_eye = true;
    for (const double depth : {-7.0, -0.25, -1e-3}) {
        TestScene t = around_the_eye(ends, depth);
        answer(t.candidate, 0, 0, 1, 4);
        EXPECT_TRUE(passes(t.class_at(0, 0))) << depth;
        answer_background(t.candidate, 0, 0);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::hole) << "the wall before the eye is drawn";
        answer(t.candidate, 0, 0, 0, depth);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::invalid) << depth;
        t.candidate_precision = whole;
        EXPECT_EQ(t.class_at(0, 0), PixelClass::agree);
        answer(t.candidate, 0, 0, 1, 4);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden) << depth;
    }
    for (const double depth : {1e-3, 0.25, 2.0}) {
        TestScene t = around_the_eye(ends, depth);
        answer(t.candidate, 0, 0, 1, 4);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::hidden) << depth;
        answer(t.candidate, 0, 0, 0, depth);
        EXPECT_EQ(t.class_at(0, 0), PixelClass::agree);
    }
}

/// A slope from depth -4 at x = 0 to 4 at x = 8 crosses the eye's plane at x = 4.
TEST(NothingBehindTheEye, WhatCrossesTheEyesPlaneEndsThere) {
    TestScene t(parallel, 8, 1, {{{{-64, -64, -68}, {192, -64, 188}, {-64, 192, -68}}}});
    t.view.camera.near_depth = -256;
    RasterPrecision p = fine_raster();
    p.nothing_behind_the_eye = true;
    t.candidate_precision = p;
    t.view.camera.far_depth = 256;
    for (int x = 0; x < 8; ++x) {
        answer(t.reference, x, 0, 0, x + 0.5 - 4);
        if (x < 4)
            answer_background(t.candidate, x, 0);
        else
            answer(t.candidate, x, 0, 0, x + 0.5 - 4);
    }
    for (int x = 0; x < 8; ++x) EXPECT_TRUE(passes(t.class_at(x, 0))) << x;
    answer_background(t.candidate, 4, 0);
    EXPECT_EQ(t.class_at(4, 0), PixelClass::hole);
}

/// A perspective ray through the image's corner: u of |x| + |y| + 1 along each axis, once or many times.
TEST(DirectionRoundings, WidenTheAim) {
    const View view = pixel_view(perspective, 16, 16);
    const double once = ViewBounds(view, RayPrecision{}).background_eps_px();
    EXPECT_NEAR(ViewBounds(view, RayPrecision{.direction_roundings = 10}).background_eps_px(), 10 * once,
                0.01 * once);
}

TEST(HitPoint, OneFromBarycentricsIsAsCoarseAsPositionsAre) {
    RayPrecision p;
    p.hit_point = HitPoint::barycentrics;
    TestScene t(parallel, 1, 1, {wall(4)});
    const auto absolute = [&](const RayPrecision& one) {
        return ViewBounds(t.view, one).of(corners_of(t.scene, 0)).depth_absolute;
    };
    EXPECT_NEAR(absolute(p) - absolute(RayPrecision{}), gamma(11, u) * 4, 1e-3 * gamma(11, u) * 4);
}

/// (v1 x v2) . d has 10 roundings of all its products; Woop's corners have 12 of the corner's size.
TEST(RayTest, EachTestHasAnErrorOfItsOwn) {
    const TestScene t(parallel, 4, 1, {wall_left_of(2.5, 4), wall(8)});
    const auto eps = [&](RayTest test) {
        return ViewBounds(t.view, RayPrecision{.test = test}).of(corners_of(t.scene, 0)).eps_base_px;
    };
    const double aim = ViewBounds(t.view, RayPrecision{}).background_eps_px();
    EXPECT_NEAR(eps(RayTest::woop), aim + u * 8 + 3 * gamma(4, u) * 516, 0.1 * eps(RayTest::woop));
    EXPECT_GT(eps(RayTest::moeller_trumbore), gamma(7, u) * 64);
    EXPECT_LT(eps(RayTest::moeller_trumbore), gamma(10, u) * 4 * 516);
}

}  // namespace
}  // namespace zproof
