/// Triangles seen exactly edge-on, and other degenerate ones, as neighbours and as answers.
#include <gtest/gtest.h>

#include "compare/explanation/explain.h"
#include "test_scene.h"

namespace zproof {
namespace {

class EdgeOn : public testing::TestWithParam<Projection> {};

INSTANTIATE_TEST_SUITE_P(Projections, EdgeOn, testing::Values(Projection::perspective, Projection::parallel),
                         [](const auto& p) {
                             return p.param == Projection::parallel ? "parallel" : "perspective";
                         });

/// Upright, in the plane that is seen as the column x; its corners from depth 2 to depth 8.
Triangle fin(double x) { return {{{x, -8, 2}, {x, 24, 2}, {x, 8, 8}}}; }

/// `within` the square of pixel (1, 1), and beyond it.
void expect_reach(TestScene t, double depth) {
    for (const Precision& precision : {raster_precision(), ray_precision()}) {
        SCOPED_TRACE(precision.index());
        t.candidate_precision = precision;
        answer(t.candidate, 1, 1, 0, depth);
        EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
        answer_background(t.candidate, 1, 1);
        answer(t.candidate, 2, 1, 0, depth);
        EXPECT_EQ(t.class_at(2, 1), PixelClass::outside);
        answer_background(t.candidate, 2, 1);
    }
}

TEST_P(EdgeOn, AFinThroughTheCentreMayBeAnsweredAtAnyOfItsDepths) {
    for (const double depth : {2.0, 5.0, 8.0}) expect_reach({GetParam(), 4, 4, {fin(1.5)}}, depth);
}

/// To a rasterizer, whose eps is small where corners are far away.
void expect_raster_reach(const Triangle& triangle, Projection projection) {
    TestScene t(projection, 4, 4, {triangle});
    answer(t.candidate, 1, 1, 0, 8);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
    answer_background(t.candidate, 1, 1);
    answer(t.candidate, 2, 1, 0, 8);
    EXPECT_EQ(t.class_at(2, 1), PixelClass::outside);
}

TEST_P(EdgeOn, AFinWhoseEdgesLieBeforeNearAndBeyondFarMayBeAnswered) {
    expect_raster_reach({{{1.5, 1.5, 0.125}, {1.5, -4096, 8192}, {1.5, 4096, 8192}}}, GetParam());
}

/// All corners on one view ray: rounding may part them.
TEST_P(EdgeOn, ALineThatIsSeenAsAPointMayBeAnsweredThere) {
    for (const double depth : {2.0, 5.0, 8.0})
        expect_reach({GetParam(), 4, 4, {{{{1.5, 1.5, 2}, {1.5, 1.5, 4}, {1.5, 1.5, 8}}}}}, depth);
    expect_raster_reach({{{1.5, 1.5, -4}, {1.5, 1.5, 8}, {1.5, 1.5, 8}}}, GetParam());
}

TEST_P(EdgeOn, AFinWhoseEdgesAreAllBeforeNearHereMayNot) {
    TestScene t(GetParam(), 4, 4, {{{{1.5, 1.5, 0.125}, {1.5, -64, 0.0625}, {1.5, 64, 0.125}}}});
    answer(t.candidate, 1, 1, 0, 8);
    EXPECT_FALSE(passes(t.class_at(1, 1)));
}

/// Corners at depths below 0 are seen through the eye, upside down.
TEST(EdgeOnPerspective, AFinThatHoldsTheEyeMayBeAnswered) {
    expect_raster_reach({{{1.5, 1.5, -4}, {1.5, -4096, 8192}, {1.5, 4096, 8192}}}, Projection::perspective);
}

TEST_P(EdgeOn, AFinHidesNothing) {
    TestScene t(GetParam(), 4, 4, {wall(16), fin(1.5)});
    answer_everywhere(t.reference, 0, 16);
    answer_everywhere(t.candidate, 0, 16);
    answer(t.candidate, 1, 1, 1, 2);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
    std::swap(t.candidate, t.reference);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
}

TEST_P(EdgeOn, AFinBehindAWallIsHidden) {
    TestScene t(GetParam(), 4, 4, {wall(1), fin(1.5)});
    answer_everywhere(t.reference, 0, 1);
    answer_everywhere(t.candidate, 0, 1);
    answer(t.candidate, 1, 1, 1, 2);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hidden);
}

TEST_P(EdgeOn, TrianglesWithoutAreaAreJudgedToo) {
    const Corner c{1.5, 1.5, 4};
    const Triangle dot{{c, c, c}}, dash{{c, c, {9, 9, 4}}}, line{{c, {5.5, 5.5, 4}, {9.5, 9.5, 4}}};
    for (const Triangle& triangle : {dash, line}) expect_reach({GetParam(), 4, 4, {triangle}}, 4);
    TestScene t(GetParam(), 4, 4, {dot});
    answer(t.candidate, 1, 1, 0, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::outside) << "a dot has no edge to be drawn by";
}

/// At depth 0 every perspective corner is the eye itself.
TEST_P(EdgeOn, TrianglesThatTouchTheEyeAreJudgedToo) {
    const Triangle touching{{{1, 1, 0}, {1.5, -8, 4}, {1.5, 16, 4}}},
        twice{{{1, 1, 0}, {1, 1, 0}, {1.5, 16, 4}}};
    for (const Triangle& triangle : {touching, twice})
        for (const Precision& precision : {raster_precision(), ray_precision()}) {
            TestScene t(GetParam(), 4, 4, {triangle, wall(8)});
            t.candidate_precision = precision;
            answer(t.candidate, 1, 1, 0, 4);
            answer(t.reference, 1, 1, 1, 8);
            EXPECT_NO_THROW(t.verdict());
            EXPECT_NO_THROW(
                explain(t.scene, t.view, {t.candidate, precision}, {t.reference, precision}, {1, 1}));
        }
}

}  // namespace
}  // namespace zproof
