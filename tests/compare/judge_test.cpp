/// The word for every kind of pixel, in both projections. The pixel asked is (1, 1), its centre (1.5, 1.5).
#include <gtest/gtest.h>

#include "test_scene.h"

namespace zproof {
namespace {

constexpr double near_the_centre = 1.5 + 1.0 / 1024;  // half of what 8 sub-pixel bits may move

class Judge : public testing::TestWithParam<Projection> {
  protected:
    TestScene test_scene(const std::vector<Triangle>& triangles) const {
        return {GetParam(), 4, 4, triangles};
    }
    /// Both renderers see the first triangle's depth everywhere.
    TestScene agreed_scene(const std::vector<Triangle>& triangles) const {
        TestScene t = test_scene(triangles);
        answer_everywhere(t.candidate, 0, triangles[0][0].depth);
        answer_everywhere(t.reference, 0, triangles[0][0].depth);
        return t;
    }
};

INSTANTIATE_TEST_SUITE_P(Projections, Judge, testing::Values(Projection::perspective, Projection::parallel),
                         [](const auto& p) {
                             return p.param == Projection::parallel ? "parallel" : "perspective";
                         });

TEST_P(Judge, FramesThatSayTheTruthAgree) {
    const Verdict verdict = agreed_scene({wall(4), wall(8)}).verdict();
    EXPECT_EQ(verdict.counts[std::size_t(PixelClass::agree)], 16u);
    EXPECT_TRUE(verdict.findings.empty());
}

TEST_P(Judge, BareImagesAgree) {
    EXPECT_EQ(test_scene({}).verdict().counts[std::size_t(PixelClass::agree)], 16u);
}

TEST_P(Judge, NeighboursAcrossAnEdgeWithinEpsAreBothAdmissible) {
    TestScene t = agreed_scene({wall_left_of(near_the_centre, 4), wall_right_of(near_the_centre, 4)});
    answer(t.candidate, 1, 1, 1, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
}

TEST_P(Judge, BackgroundBesideASilhouetteWithinEpsIsAdmissible) {
    TestScene t = agreed_scene({wall_left_of(near_the_centre, 4)});
    answer_background(t.candidate, 1, 1);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
}

TEST_P(Judge, CoplanarTrianglesTie) {
    TestScene t = agreed_scene({wall(4), wall_left_of(9, 4)});
    answer(t.candidate, 1, 1, 1, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::depth_tie);
}

TEST_P(Judge, ACrackBetweenEdgesThatOccludersDoNotShareIsTheScenesDefect) {
    TestScene t = agreed_scene({wall_left_of(1.5, 4, -64, 64), wall_right_of(1.5, 4, -32, 96), wall(8)});
    answer(t.candidate, 1, 1, 2, 8);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::abutting_edges);
}

TEST_P(Judge, BackgroundSeenThroughACrackIsTheScenesDefect) {
    TestScene t = agreed_scene({wall_left_of(1.5, 4, -64, 64), wall_right_of(1.5, 4, -32, 96)});
    answer_background(t.candidate, 1, 1);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::abutting_edges);
}

TEST_P(Judge, NothingShowsThroughASharedEdge) {
    TestScene t = agreed_scene({wall_left_of(1.5, 4), wall_right_of(1.5, 4), wall(8)});
    answer(t.candidate, 1, 1, 2, 8);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hidden);
    answer_background(t.candidate, 1, 1);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hole);
}

TEST_P(Judge, ATriangleNeverHidesItsNeighbourAcrossTheirEdge) {
    const Triangle left = wall_left_of(1.5, 4), right = {{{1.5, -64, 4}, {512, 8, 900}, {1.5, 64, 4}}};
    // the third covers just the right half of the square; the left half is left's own
    TestScene t = agreed_scene({left, right, wall_right_of(1.5, 2)});
    answer(t.candidate, 1, 1, 1, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::edge);
}

/// Such an edge has no line in the image: all of it lies on the side of both triangles.
TEST(JudgeInPerspective, TrianglesThatShareAnEdgeBesideTheEyeHideEachOther) {
    TestScene t(Projection::perspective, 4, 4, {});
    const glm::vec3 a{-8, -1, 0}, b{8, -1, 0}, near_tip{0, 0, -4}, far_tip{0, 0, -8};
    t.scene.vertices.position_world = {a, b, near_tip, far_tip};
    t.scene.triangles = {{0, 1, 2}, {0, 1, 3}};
    // the ray (1.5, -1.5, -1) t meets the nearer one at t = 1 / 1.75, the other at 1 / 1.625
    answer(t.reference, 1, 1, 0, 1 / 1.75);
    answer(t.candidate, 1, 1, 1, 1 / 1.625);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hidden);
}

/// A slope that reaches the near depth (1/4) at x = 1.5 and is cut off to its left.
Triangle slope_through_near(Projection projection) {
    const bool perspective = projection == Projection::perspective;
    const double left = perspective ? 1 / 5.0 : 0, right = perspective ? 1 / 2.0 : 0.75;
    return {{{-30.5, -64, left}, {65.5, -64, right}, {-30.5, 256, left}}};
}

TEST_P(Judge, BackgroundWhereTheNearPlaneCutsIsAdmissible) {
    TestScene t = test_scene({slope_through_near(GetParam())});
    answer(t.reference, 1, 1, 0, 0.25);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::clip);
}

TEST_P(Judge, ATriangleBehindTheNearPlaneReachesNoPixel) {
    TestScene t = test_scene({slope_through_near(GetParam())});
    answer(t.candidate, 0, 1, 0, 0.25);
    EXPECT_EQ(t.class_at(0, 1), PixelClass::outside);
}

TEST_P(Judge, TheRightTriangleAtTheWrongDepthIsWrong) {
    TestScene t = agreed_scene({wall(4)});
    answer(t.candidate, 1, 1, 0, 4.01);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::wrong_depth);
}

TEST_P(Judge, AnAdmissibleNeighbourAtTheWrongDepthIsWrong) {
    TestScene t = agreed_scene({wall_left_of(near_the_centre, 4), wall_right_of(near_the_centre, 4)});
    answer(t.candidate, 1, 1, 1, 4.01);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::wrong_depth);
}

TEST_P(Judge, BackgroundOnACoveredPixelIsAHole) {
    TestScene t = agreed_scene({wall(4)});
    answer_background(t.candidate, 1, 1);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hole);
}

TEST_P(Judge, ATriangleThatEndsBeforeThePixelIsOutside) {
    TestScene t = test_scene({wall_left_of(1, 4)});
    answer(t.candidate, 1, 1, 0, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::outside);
}

TEST_P(Judge, ATriangleThatEndsBeforeThePixelIsNoTieWithTheWallInItsPlane) {
    TestScene t = agreed_scene({wall(4), wall_right_of(2, 4)});
    answer(t.candidate, 3, 1, 1, 4);  // a tie, so that both are known beside each other
    answer(t.candidate, 0, 1, 1, 4);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(3, 1), PixelClass::depth_tie);
    EXPECT_EQ(verdict.classes.at(0, 1), PixelClass::outside);
}

TEST_P(Judge, ATriangleBehindAWallIsHidden) {
    TestScene t = agreed_scene({wall(4), wall(8)});
    answer(t.candidate, 1, 1, 1, 8);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hidden);
}

TEST_P(Judge, AHiddenTriangleIsHiddenWhateverDepthItClaims) {
    TestScene t = agreed_scene({wall(4), wall(8)});
    answer(t.candidate, 1, 1, 1, 4);
    EXPECT_EQ(t.class_at(1, 1), PixelClass::hidden);
}

TEST_P(Judge, AnUnlawfulReferenceIsTheReferencesDefect) {
    TestScene t = agreed_scene({wall(4), wall(8)});
    answer_background(t.reference, 0, 0);
    answer(t.reference, 1, 1, 1, 8);
    answer(t.reference, 2, 2, 0, 4.01);
    answer(t.reference, 3, 3, 7, 4);
    const Verdict verdict = t.verdict();
    for (const int i : {0, 1, 2, 3}) EXPECT_EQ(verdict.classes.at(i, i), PixelClass::reference_wrong) << i;
    EXPECT_EQ(verdict.reference_defects, 4u);
    EXPECT_EQ(defect_count(verdict), 0u);
}

TEST_P(Judge, WhereBothAreWrongTheCandidatesDefectIsTheWord) {
    TestScene t = agreed_scene({wall(4), wall(8), wall(16)});
    answer(t.candidate, 1, 1, 1, 8);
    answer(t.reference, 1, 1, 2, 16);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), PixelClass::hidden);
    EXPECT_EQ(verdict.reference_defects, 1u);
}

}  // namespace
}  // namespace zproof
