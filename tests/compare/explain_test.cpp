#include "compare/explanation/explain.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "compare/explanation/explainer.h"
#include "compare/explanation/illustration.h"
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

/// Walls one behind the other, each of which ends within eps of the centre of pixel (1, 1).
TestScene crowd(int count) {
    std::vector<Triangle> walls;
    for (int i = 0; i < count; ++i) walls.push_back(wall_left_of(1.5 + i % 7 / 2048.0, 4 + i / 64.0));
    TestScene t(Projection::parallel, 4, 4, walls);
    answer_everywhere(t.reference, 0, 4);
    answer_everywhere(t.candidate, std::uint32_t(count - 1), 4);
    return t;
}

/// Work in cuts, of what was asked about.
std::size_t work_of(const PixelExplanation& e) {
    std::size_t work = e.background.work;
    for (const Candidate& c : e.candidates) work += c.decision.work;
    return work;
}

TEST(Explain, SpendsNoMoreThanItIsGivenAndSaysWhatIsLeftOut) {
    const TestScene t = crowd(60);
    const Explainer explainer(t.scene, t.view, {t.candidate, t.candidate_precision},
                              {t.reference, t.reference_precision});
    const PixelCoord place{1, 1};
    const auto explained = [&](std::size_t most_work) {
        PixelExplanation e = explainer.begin({&place, 1}).front();
        SearchPixel search_pixel = search_pixel_of(e);
        explainer.search({&search_pixel, 1});
        explainer.finish(e, search_pixel, most_work);
        return e;
    };
    const PixelExplanation whole = explained(500'000);
    ASSERT_EQ(whole.left_out, 0u);
    ASSERT_EQ(whole.candidates.size(), 60u);
    EXPECT_EQ(in_words(t.scene, whole).find("not asked about"), std::string::npos);
    const std::size_t half = work_of(whole) / 2;
    const PixelExplanation part = explained(half);
    EXPECT_GT(part.left_out, 0u);
    EXPECT_EQ(part.candidates.size() + part.left_out, 60u);
    ASSERT_GT(part.candidates.size(), 1u);
    // The last one may go beyond by what it takes to see that it does.
    EXPECT_LE(work_of(part) - part.candidates.back().decision.work, half);
    for (std::size_t i = 0; i + 1 < part.candidates.size(); ++i) {
        EXPECT_EQ(part.candidates[i].primitive, whole.candidates[i].primitive);
        EXPECT_EQ(part.candidates[i].decision.admissibility, whole.candidates[i].decision.admissibility);
    }
    EXPECT_NE(
        in_words(t.scene, part)
            .find("not asked about: " + std::to_string(part.left_out) + " farther triangles around, since"),
        std::string::npos);
    EXPECT_EQ(explained(0).left_out, 60u);
}

TEST(Explain, ManyPixelsOfAViewShareItsWork) {
    const TestScene t = crowd(60);
    const RenderedFrame candidate{t.candidate, t.candidate_precision},
        reference{t.reference, t.reference_precision};
    const std::vector<PixelCoord> one(1, {1, 1});
    std::vector<PixelCoord> many(599, {3, 3});  // where nothing is near
    many.push_back(one.front());
    const auto told = [&](std::span<const PixelCoord> places) {
        return illustrate(t.scene, t.view, candidate, reference, {places, 1, 4}).back().explanation;
    };
    EXPECT_EQ(told(one).left_out, 0u);
    const PixelExplanation alone = told(many),
                           on_one_thread = tbb::task_arena(1).execute([&] { return told(many); });
    EXPECT_GT(alone.left_out, 0u);
    EXPECT_LE(work_of(alone) - alone.candidates.back().decision.work, (std::size_t{1} << 22) / many.size());
    EXPECT_EQ(in_words(t.scene, alone), in_words(t.scene, on_one_thread));
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
