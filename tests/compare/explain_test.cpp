#include "compare/explanation/explain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "test_scene.h"

namespace zproof {
namespace {

PixelExplanation explanation_of(const TestScene& t, int x, int y) {
    return explain(t.scene, t.view, {t.candidate, t.candidate_precision},
                   {t.reference, t.reference_precision}, {x, y});
}

/// A left and a right wall that meet half of eps beyond the centre of pixel (1, 1), before a third.
TestScene meeting_walls() {
    TestScene t(Projection::parallel, 4, 4,
                {wall_left_of(1.5 + 1.0 / 1024, 4), wall_right_of(1.5 + 1.0 / 1024, 4), wall(8)});
    answer_everywhere(t.reference, 0, 4);
    answer_everywhere(t.candidate, 0, 4);
    answer(t.candidate, 1, 1, 1, 4);
    return t;
}

TEST(Explain, TellsEveryTriangleWithinEpsNearestFirst) {
    const PixelExplanation explanation = explanation_of(meeting_walls(), 1, 1);
    EXPECT_EQ(explanation.finding.verdict, PixelClass::edge);
    ASSERT_EQ(explanation.candidates.size(), 3u);
    EXPECT_EQ(explanation.candidates[0].primitive, PrimitiveId(0));
    EXPECT_EQ(explanation.candidates[2].primitive, PrimitiveId(2));
    EXPECT_EQ(explanation.candidates[0].depth.truth, 4);
    EXPECT_EQ(explanation.candidates[1].decision.admissibility, Admissibility::visible);
    EXPECT_EQ(explanation.candidates[2].decision.admissibility, Admissibility::hidden);
    EXPECT_EQ(explanation.candidate.admissibility, Admissibility::visible);
    EXPECT_EQ(explanation.reference.admissibility, Admissibility::visible);
    EXPECT_EQ(explanation.background.admissibility, Admissibility::hole);
}

TEST(Explain, EdgeDistancesAreIn256thsOfAPixelPositiveInside) {
    const PixelExplanation explanation = explanation_of(meeting_walls(), 1, 1);
    // edge 2 of the left wall and edge 1 of the right wall is the one in which they meet
    EXPECT_DOUBLE_EQ(explanation.candidates[0].edge_distance[2], 0.25);
    EXPECT_DOUBLE_EQ(explanation.candidates[1].edge_distance[1], -0.25);
    EXPECT_GT(explanation.candidates[0].edge_distance[0], 256);
}

TEST(Explain, ATriangleSeenEdgeOnHasNoDistances) {
    TestScene t(Projection::perspective, 4, 4, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
    answer(t.candidate, 1, 1, 0, 4);
    const PixelExplanation explanation = explanation_of(t, 1, 1);
    ASSERT_EQ(explanation.candidates.size(), 1u);
    for (const double distance : explanation.candidates[0].edge_distance) EXPECT_TRUE(std::isnan(distance));
}

TEST(Explain, SaysInWordsThatADepthIsNotANumber) {
    TestScene t = meeting_walls();
    answer(t.candidate, 1, 1, 0, NAN);
    const PixelExplanation explanation = explanation_of(t, 1, 1);
    EXPECT_EQ(explanation.finding.verdict, PixelClass::invalid);
    const std::string words = in_words(t.scene, explanation);
    EXPECT_NE(words.find("that is no answer: depth not a number\n"), std::string::npos) << words;
    EXPECT_EQ(words.find("nan"), std::string::npos) << words;
    Finding wrong = explanation.finding;
    wrong.verdict = PixelClass::wrong_depth;
    wrong.error_over_bound = NAN;
    const std::string sentence = in_words(t.scene, wrong);
    EXPECT_NE(sentence.find("depth not a number, admissible from"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("error/bound"), std::string::npos) << sentence;
}

TEST(Explain, SaysTheVerdictOfTheJudgeAtEveryPixel) {
    TestScene t = meeting_walls();
    answer(t.candidate, 0, 1, 2, 8);
    answer(t.candidate, 2, 2, 1, 4.5);
    answer(t.candidate, 3, 3, 0, -1);
    answer_background(t.candidate, 0, 3);
    const Verdict verdict = t.verdict();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(explanation_of(t, x, y).finding.verdict, verdict.classes.at(x, y)) << x << ' ' << y;
}

TEST(Explain, APixelOutsideTheViewIsRefused) {
    const TestScene t = meeting_walls();
    EXPECT_THROW(explanation_of(t, 4, 0), std::out_of_range);
    EXPECT_THROW(explanation_of(t, 0, -1), std::out_of_range);
}

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Words, EveryClassHasItsReason) {
    const std::array<const char*, pixel_class_count> reasons{
        "same id",           "they meet at an edge",   "depths tie",         "through a crack",
        "near or far plane", "the reference is not",   "undecidable at eps", "an attribute is not",
        "the depth is not",  "is covered for certain", "does not come",      "is occluded for certain",
        "that is no answer"};
    const Scene scene;
    Finding f;
    f.candidate = {PrimitiveId(3), 2};
    for (int c = 0; c < pixel_class_count; ++c) {
        f.verdict = PixelClass(c);
        EXPECT_TRUE(says(in_words(scene, f), reasons[std::size_t(c)])) << in_words(scene, f);
        EXPECT_TRUE(says(in_words(scene, f), "candidate says triangle 3, reference background: "));
    }
}

TEST(Words, NameTheNodeAndTheMesh) {
    TestScene t = meeting_walls();
    t.scene.parts = {{"Wheel", "Spokes", 0, 0, 1, 0}, {"", "", 0, 1, 2, 0}};
    const std::string text = in_words(t.scene, explanation_of(t, 1, 1));
    EXPECT_TRUE(says(text, "pixel (1, 1): edge, pass\n")) << text;
    EXPECT_TRUE(says(text, "triangle 0 (node Wheel, mesh Spokes)"));
    EXPECT_TRUE(says(text, "triangle 1 (node unnamed, mesh unnamed)"));
    EXPECT_TRUE(says(text, "not admissible: occluded for certain"));
    EXPECT_TRUE(says(text, "background: not admissible: covered for certain\n"));
}

TEST(Words, ADefectFails) {
    TestScene t = meeting_walls();
    answer(t.candidate, 1, 1, 2, 8);
    EXPECT_TRUE(says(in_words(t.scene, explanation_of(t, 1, 1)), "pixel (1, 1): hidden, FAIL\n"));
}

}  // namespace
}  // namespace zproof
