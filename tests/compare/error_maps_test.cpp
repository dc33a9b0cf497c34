/// Maps of errors, and explanations of many pixels at once.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "compare/bounds/triangle_depth.h"
#include "compare/explanation/illustration.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// Two walls at depths 4 and 8; the reference always sees the first.
TestScene before_walls(Projection projection) {
    TestScene t(projection, 8, 8, {wall(4), wall(8)});
    answer_everywhere(t.candidate, 0, 4);
    answer_everywhere(t.reference, 0, 4);
    return t;
}

/// |depth - truth| / bound of a frame's own triangles, one by one.
Plane<float> errors_of(const TestScene& t, const Frame& frame, const Precision& precision) {
    const ViewBounds bounds(t.view, precision);
    Plane<float> map(frame.size(), std::numeric_limits<float>::quiet_NaN());
    for (int y = 0; y < t.view.height; ++y)
        for (int x = 0; x < t.view.width; ++x) {
            const auto triangle = std::uint32_t(frame.primitive.at(x, y));
            if (triangle >= t.scene.triangles.size()) continue;
            const TriangleDepth depth(TriangleInView(t.view, bounds, corners_of(t.scene, triangle)), bounds);
            map.at(x, y) = float(error_over_bound(depth.at(x, y), frame.camera_depth.at(x, y)));
        }
    return map;
}

TEST(ErrorMaps, AreWhatTheJudgeHoldsAgainstTheBoundAtEveryPixel) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        TestScene t = before_walls(projection);
        answer(t.candidate, 3, 2, 0, std::nextafter(4.0f, 5.0f));
        answer(t.candidate, 4, 2, 0, 4.5);
        answer(t.candidate, 5, 2, 1, 8);
        const Verdict verdict = t.verdict();
        const Plane<float>& map = verdict.errors->candidate;
        ASSERT_GE(verdict.findings.size(), 2u);
        for (const Finding& f : verdict.findings)
            EXPECT_EQ(map.at(f.x, f.y), float(f.error_over_bound)) << f.x << ' ' << f.y;
        EXPECT_EQ(map.at(0, 0), 0);
        EXPECT_GT(map.at(3, 2), 0);
        EXPECT_GT(map.at(4, 2), 1);
        EXPECT_EQ(map.at(5, 2), 0) << "its own triangle's depth";
    }
}

/// But for the NaNs', of which there are many kinds.
std::vector<std::uint32_t> bits_of(const Plane<float>& map) {
    std::vector<std::uint32_t> bits;
    for (const float value : map.pixels())
        bits.push_back(std::isnan(value) ? 0xFFFF'FFFF : std::bit_cast<std::uint32_t>(value));
    return bits;
}

TEST(ErrorMaps, AreThoseOfPixelsOneByOneBitForBit) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        TestScene t(projection, 131, 37, {wall(4), wall(8), {{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
        for (int y = 0; y < 37; ++y)
            for (int x = 0; x < 131; ++x) {
                const int which = (x / 3 + y) % 7;
                const float off = 1 + float(x - 60) * float(y) * 1e-9f;
                answer(t.candidate, x, y, which, which == 5 ? NAN : (which == 1 ? 8.0f : 4.0f) * off);
                answer(t.reference, x, y, which == 3 ? 0 : which, 4.0f * off);
                if (which == 6) answer_background(t.candidate, x, y);
            }
        const Verdict verdict = t.verdict();
        EXPECT_EQ(bits_of(verdict.errors->candidate),
                  bits_of(errors_of(t, t.candidate, t.candidate_precision)));
        EXPECT_EQ(bits_of(verdict.errors->reference),
                  bits_of(errors_of(t, t.reference, t.reference_precision)));
    }
}

TEST(ErrorMaps, AskNothingWhereThereIsNoTriangleOrNoDepth) {
    TestScene t = before_walls(Projection::parallel);
    answer_background(t.candidate, 1, 1);
    answer(t.candidate, 2, 1, 2, 4);
    answer(t.candidate, 3, 1, 0, NAN);
    const Verdict verdict = t.verdict();
    for (int x = 1; x <= 3; ++x) EXPECT_TRUE(std::isnan(verdict.errors->candidate.at(x, 1))) << x;
}

/// Nothing bounds the depth of a triangle that is seen edge-on.
TEST(ErrorMaps, AskNothingOfADepthThatIsNoneWhereNothingBoundsIt) {
    TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
    t.candidate_precision = ray_precision();
    answer(t.candidate, 1, 1, 0, NAN);
    EXPECT_TRUE(std::isnan(t.verdict().errors->candidate.at(1, 1)));
}

TEST(ErrorMaps, AreMadeWhereTheyAreAskedFor) {
    const TestScene t = before_walls(Projection::parallel);
    const RenderedFrame ours{t.candidate, t.candidate_precision}, theirs{t.reference, t.reference_precision};
    EXPECT_FALSE(judge(t.scene, t.view, ours, theirs).errors);
    EXPECT_TRUE(judge(t.scene, t.view, ours, theirs, full_detail).errors);
}

std::vector<std::vector<NearbyImage>> images_around(const TestScene& t, std::span<const PixelCoord> places,
                                                    std::size_t most) {
    std::vector<std::vector<NearbyImage>> images;
    for (auto& [explanation, drawn] : illustrate(t.scene, t.view, {t.candidate, t.candidate_precision},
                                                 {t.reference, t.reference_precision}, {places, 1.0, most}))
        images.push_back(std::move(drawn));
    return images;
}

TEST(Illustration, GivesTheTrianglesAroundAPixelNearestFirstWithDistancesInPixels) {
    const TestScene t(Projection::parallel, 4, 4,
                      {wall(8), wall_left_of(1.75, 4), wall_right_of(3.25, 2), wall(16)});
    const PixelCoord places[] = {{1, 1}, {3, 1}};
    const auto images = images_around(t, places, 2);
    ASSERT_EQ(images.size(), 2u);
    ASSERT_EQ(images[0].size(), 2u) << "the far wall is one too many, the right one too far away";
    EXPECT_EQ(images[0][0].primitive, PrimitiveId(1));
    EXPECT_EQ(images[0][1].primitive, PrimitiveId(0));
    EXPECT_EQ(images[1][0].primitive, PrimitiveId(2));
    const Affine<double>& right_side = images[0][0].edge[2];
    EXPECT_DOUBLE_EQ(right_side.c, 0.25);
    EXPECT_DOUBLE_EQ(right_side.a, -1);
    EXPECT_DOUBLE_EQ(images[0][0].inverse_depth.c, -4) << "parallel: inverse depth is -depth";
}

TEST(Illustration, ATriangleSeenEdgeOnIsNotDrawn) {
    const TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
    const PixelCoord place{1, 1};
    EXPECT_TRUE(images_around(t, std::span(&place, 1), 9).front().empty());
}

TEST(Explain, ManyPixelsAtOnceAreWhatEachIsByItself) {
    TestScene t = before_walls(Projection::perspective);
    answer(t.candidate, 2, 2, 1, 8);
    answer(t.candidate, 3, 3, 7, 8);
    answer_background(t.candidate, 4, 4);
    const PixelCoord places[] = {{2, 2}, {0, 0}, {3, 3}, {4, 4}};
    const RenderedFrame ours{t.candidate, t.candidate_precision}, theirs{t.reference, t.reference_precision};
    const auto explanations = explain(t.scene, t.view, ours, theirs, places);
    ASSERT_EQ(explanations.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(in_words(t.scene, explanations[i]),
                  in_words(t.scene, explain(t.scene, t.view, ours, theirs, places[i])));
}

TEST(Explain, WhatIsDrawnBesideAStoryDoesNotChangeIt) {
    TestScene t = before_walls(Projection::perspective);
    answer(t.candidate, 2, 2, 1, 8);
    answer_background(t.candidate, 4, 4);
    answer_background(t.reference, 5, 4);
    const RenderedFrame ours{t.candidate, t.candidate_precision}, theirs{t.reference, t.reference_precision};
    const PixelCoord places[] = {{5, 4}, {2, 2}, {0, 0}, {4, 4}};
    const auto illustrated = illustrate(t.scene, t.view, ours, theirs, {places, 1, 9});
    ASSERT_EQ(illustrated.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const PixelExplanation explanation = explain(t.scene, t.view, ours, theirs, places[i]);
        EXPECT_EQ(in_words(t.scene, illustrated[i].explanation), in_words(t.scene, explanation));
        EXPECT_EQ(illustrated[i].explanation.reference.admissibility, explanation.reference.admissibility);
        EXPECT_EQ(illustrated[i].explanation.reference.eps_px, explanation.reference.eps_px);
    }
}

TEST(Explain, AnIdThatDoesNotExistInBothFramesHasAStoryToo) {
    TestScene t = before_walls(Projection::perspective);
    answer(t.candidate, 1, 1, 99, 4);
    answer(t.reference, 1, 1, 99, 4);
    const PixelExplanation explanation = explain(t.scene, t.view, {t.candidate, t.candidate_precision},
                                                 {t.reference, t.reference_precision}, {1, 1});
    EXPECT_EQ(explanation.finding.verdict, PixelClass::invalid);
}

}  // namespace
}  // namespace zproof
