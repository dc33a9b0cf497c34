/// How much of eps an answer needs, for edges whose distance from the centre (1.5, 1.5) is known.
#include <gtest/gtest.h>

#include <numeric>

#include "bisected.h"
#include "compare/admissible/admissibility.h"
#include "compare/admissible/displacement.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// Half a grid step: all of eps but the transform's share, which is some 1e-11 px in double.
constexpr double eps_px = 1.0 / 512;

std::uint64_t recorded(const BoundRecord& record) {
    return std::accumulate(record.histogram.begin(), record.histogram.end(), std::uint64_t(0));
}

class Displacement : public testing::TestWithParam<Projection> {
  protected:
    TestScene test_scene(const std::vector<Triangle>& triangles) const {
        return {GetParam(), 4, 4, triangles};
    }
    TestScene agreed_scene(const std::vector<Triangle>& triangles) const {
        TestScene t = test_scene(triangles);
        answer_everywhere(t.candidate, 0, triangles[0][0].depth);
        answer_everywhere(t.reference, 0, triangles[0][0].depth);
        return t;
    }
};

INSTANTIATE_TEST_SUITE_P(Projections, Displacement,
                         testing::Values(Projection::perspective, Projection::parallel), [](const auto& p) {
                             return p.param == Projection::parallel ? "parallel" : "perspective";
                         });

/// Rounded down to 1/1024.
void expect_only(const BoundRecord& record, double displacement_px) {
    const double ratio = displacement_px / eps_px;
    EXPECT_EQ(recorded(record), 1u);
    EXPECT_LE(record.max_error_over_bound, ratio);
    EXPECT_GT(record.max_error_over_bound, ratio - 2.0 / 1024);
}

TEST_P(Displacement, OfANeighbourIsItsDistanceFromTheCentre) {
    for (const double distance : {0.1, 0.5, 0.9}) {
        const double edge = 1.5 + distance * eps_px;
        TestScene t = agreed_scene({wall_left_of(edge, 4), wall_right_of(edge, 4)});
        answer(t.candidate, 1, 1, 1, 4);
        const Verdict verdict = t.verdict();
        expect_only(verdict.candidate_edges, distance * eps_px);
        EXPECT_EQ(recorded(verdict.reference_edges), 0u) << "it is right at the centre";
    }
}

TEST_P(Displacement, OfBackgroundIsHowFarTheSilhouetteMovedAside) {
    TestScene t = agreed_scene({wall_left_of(1.5 + 0.75 * eps_px, 4)});
    answer_background(t.candidate, 1, 1);
    expect_only(t.verdict().candidate_edges, 0.75 * eps_px);
}

TEST_P(Displacement, OfAWallBehindIsHowFarItsOccluderMovedAside) {
    TestScene t = agreed_scene({wall_left_of(1.5 + 0.75 * eps_px, 4), wall(8)});
    answer(t.candidate, 1, 1, 1, 8);
    expect_only(t.verdict().candidate_edges, 0.75 * eps_px);
}

TEST_P(Displacement, OfTheReferenceIsItsOwn) {
    const double edge = 1.5 + 0.5 * eps_px;
    TestScene t = agreed_scene({wall_left_of(edge, 4), wall_right_of(edge, 4)});
    t.reference_precision = RasterPrecision{.transform = Arithmetic::float64, .subpixel_bits = 7};
    answer(t.reference, 1, 1, 1, 4);
    const Verdict verdict = t.verdict();
    expect_only(verdict.reference_edges, 0.25 * eps_px);
    EXPECT_EQ(recorded(verdict.candidate_edges), 0u);
}

TEST_P(Displacement, IsMeasuredAlongTheAxesOfTheGrid) {
    // a diagonal edge: x + y moves by twice what either moves
    const double away = 2 * 0.75 * eps_px;
    const Triangle above{{{-13, 16 + away, 4}, {16 + away, -13, 4}, {-64, -64, 4}}};
    const Triangle below{{{-13, 16 + away, 4}, {64, 64, 4}, {16 + away, -13, 4}}};
    TestScene t = agreed_scene({above, below});
    answer(t.candidate, 1, 1, 1, 4);
    expect_only(t.verdict().candidate_edges, 0.75 * eps_px);
}

TEST_P(Displacement, OfAnEdgeThroughTheCentreIsNone) {
    TestScene t = agreed_scene({wall_left_of(1.5, 4), wall_right_of(1.5, 4)});
    answer(t.candidate, 1, 1, 1, 4);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), PixelClass::edge);
    EXPECT_EQ(recorded(verdict.candidate_edges), 0u);
    EXPECT_EQ(recorded(verdict.reference_edges), 0u);
}

TEST_P(Displacement, IsNotAskedOfTiesAndDefects) {
    TestScene t = agreed_scene({wall(4), wall_left_of(9, 4), wall(8)});
    answer(t.candidate, 1, 1, 1, 4);
    answer(t.candidate, 2, 1, 2, 8);
    answer_background(t.candidate, 3, 1);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(1, 1), PixelClass::depth_tie);
    EXPECT_EQ(defect_count(verdict), 2u);
    EXPECT_EQ(recorded(verdict.candidate_edges), 0u);
}

/// Two walls that meet beside the centre, before a third.
TEST(DisplacementOf, IsTheLeastStepFromWhicheverStepItIsLookedFor) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const ViewBounds bounds(view, raster_precision());
    for (const int step : {1, 2, 3, 17, 511, 512, 513, 1022, 1023}) {
        const double edge = 1.5 + (step - 0.5) / displacement_steps * eps_px;
        const Scene scene = scene_of(view, {wall_left_of(edge, 4), wall_right_of(edge, 4), wall(8)});
        const Neighbourhood around = surroundings(scene, view, bounds, {1, 1}, 0);
        const auto found = displacement_of(around, PrimitiveId(1)).over_eps;
        EXPECT_EQ(found, bisected_displacement(around, PrimitiveId(1))) << step;
        const double expected = double(step - 1) / displacement_steps;
        EXPECT_NEAR(found.value_or(0), expected, 1.5 / displacement_steps) << step;
    }
}

TEST(DisplacementOf, IsWhatBisectionFindsWhateverIsCertainInDouble) {
    int moved = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        std::vector<PrimitiveId> answers{PrimitiveId::none};
        for (const Neighbour& n : s.around.neighbours) answers.push_back(PrimitiveId(n.triangle));
        for (const PrimitiveId answer : answers) {
            if (decide(s.around, answer).admissibility != Admissibility::visible) continue;
            const auto found = displacement_of(s.around, answer).over_eps;
            ASSERT_EQ(found, bisected_displacement(s.around, answer)) << int(answer);
            ++asked, moved += found.has_value();
        }
    }
    EXPECT_GT(asked, 500);
    EXPECT_GT(moved, 50);
}

}  // namespace
}  // namespace zproof
