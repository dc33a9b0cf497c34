/// What a verdict holds beside the classes: counts, findings, depth records.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "test_scene.h"

namespace zproof {
namespace {

/// A wall with one pixel of each of four classes and a background row that agrees.
TestScene mixed_scene() {
    TestScene t(Projection::parallel, 5, 3, {wall(4), wall(8)});
    answer_everywhere(t.candidate, 0, 4);
    answer_everywhere(t.reference, 0, 4);
    answer_background(t.candidate, 3, 2);
    answer(t.candidate, 4, 0, 1, 8);
    answer(t.candidate, 0, 1, 0, 5);
    answer(t.candidate, 2, 1, 2, 4);
    answer(t.reference, 1, 0, 1, 8);
    return t;
}

TEST(Verdict, CountsEveryPixelOnce) {
    const Verdict verdict = mixed_scene().verdict();
    ClassCounts expected{};
    expected[std::size_t(PixelClass::agree)] = 10;
    for (const PixelClass c : {PixelClass::hole, PixelClass::hidden, PixelClass::wrong_depth,
                               PixelClass::invalid, PixelClass::reference_wrong})
        expected[std::size_t(c)] = 1;
    EXPECT_EQ(verdict.counts, expected);
    EXPECT_EQ(defect_count(verdict), 4u);
    EXPECT_EQ(verdict.reference_defects, 1u);
}

TEST(Verdict, ListsFindingsInRasterOrderWithBothAnswers) {
    const Verdict verdict = mixed_scene().verdict();
    const std::vector<std::array<int, 2>> expected{{1, 0}, {4, 0}, {0, 1}, {2, 1}, {3, 2}};
    ASSERT_EQ(verdict.findings.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Finding& f = verdict.findings[i];
        EXPECT_EQ((std::array{f.x, f.y}), expected[i]);
        EXPECT_EQ(f.verdict, verdict.classes.at(f.x, f.y));
    }
    EXPECT_EQ(verdict.findings[1].candidate.primitive, PrimitiveId(1));
    EXPECT_EQ(verdict.findings[1].candidate.camera_depth, 8.f);
    EXPECT_EQ(verdict.findings[1].reference.primitive, PrimitiveId(0));
    EXPECT_EQ(verdict.findings[1].reference.camera_depth, 4.f);
}

TEST(Verdict, AFindingTellsTheSquareAndTheDepthBound) {
    const TestScene t = mixed_scene();
    const Verdict verdict = t.verdict();
    const Finding &hidden = verdict.findings[1], &hole = verdict.findings[4];
    EXPECT_EQ(hidden.eps_px, t.candidate_eps_px(4, 0, 1));
    EXPECT_EQ(hidden.candidate_depth.truth, 8);
    EXPECT_LT(hidden.candidate_depth.low, 8);
    EXPECT_GT(hidden.candidate_depth.high, 8);
    EXPECT_EQ(hidden.error_over_bound, 0);
    EXPECT_GE(hole.eps_px, ViewBounds(t.view, t.candidate_precision).background_eps_px());
    EXPECT_TRUE(std::isnan(hole.candidate_depth.truth));
    EXPECT_TRUE(std::isnan(hole.error_over_bound));
}

TEST(Verdict, OnlyPixelsOfDifferentIdsAreAdjudicated) { EXPECT_EQ(mixed_scene().verdict().adjudicated, 4u); }

/// A pixel is 1/3 unit wide, which no double holds: that the two walls meet at the centre of pixel 1, at 1/2,
/// and leave nothing between them, only rationals see.
TEST(Verdict, ExactRationalsAreCountedWhereTheyDecide) {
    TestScene t(Projection::parallel, 3, 1,
                {wall_left_of(0.5, 4, -64, 64), wall_right_of(0.5, 5, -32, 96), wall(8)});
    t.view.camera.window.right = 1;
    answer_everywhere(t.candidate, 2, 8);
    answer_everywhere(t.reference, 0, 4);
    answer(t.candidate, 0, 0, 0, 4);
    answer(t.candidate, 2, 0, 1, 5);
    answer_background(t.reference, 2, 0);
    const Verdict verdict = t.verdict();
    EXPECT_EQ(verdict.classes.at(0, 0), PixelClass::agree);
    EXPECT_EQ(verdict.classes.at(1, 0), PixelClass::abutting_edges);
    EXPECT_EQ(verdict.classes.at(2, 0), PixelClass::reference_wrong);
    EXPECT_EQ(verdict.adjudicated, 2u);
    EXPECT_EQ(verdict.exact, 1u);
}

TEST(Verdict, DepthsAreHeldAgainstTheBoundOnTheirSide) {
    TestScene t(Projection::parallel, 4, 1, {wall(4)});
    t.candidate_precision = RasterPrecision{.depth_roundings = 4};  // 2 ulps of float32
    answer_everywhere(t.candidate, 0, 4);
    answer_everywhere(t.reference, 0, 4);
    const float above = std::nextafter(4.f, 5.f);
    answer(t.candidate, 2, 0, 0, above);
    answer(t.candidate, 3, 0, 0, 400);
    const Verdict verdict = t.verdict();
    const BoundHistogram& histogram = verdict.candidate_depth.histogram;
    EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), std::uint64_t(0)), 4u);
    EXPECT_EQ(histogram[0], 2u) << "two pixels without error";
    EXPECT_EQ(histogram[20], 1u) << "one beyond its bound";
    EXPECT_EQ(verdict.reference_depth.histogram[0], 4u);
    EXPECT_EQ(verdict.reference_depth.max_error_over_bound, 0);
    const Finding& far = verdict.findings.front();
    EXPECT_EQ(far.error_over_bound, verdict.candidate_depth.max_error_over_bound);
    EXPECT_DOUBLE_EQ(far.error_over_bound, (400 - 4) / (far.candidate_depth.high - 4));
    const double step = (double(above) - 4) / (far.candidate_depth.high - 4);
    EXPECT_EQ(histogram[std::size_t(20 * step)], 1u) << step;
}

TEST(Verdict, DepthsOfDifferentIdsAreNotRecorded) {
    TestScene t(Projection::parallel, 1, 1, {wall(4), wall(8)});
    answer(t.candidate, 0, 0, 0, 4);
    answer(t.reference, 0, 0, 1, 8);
    const BoundHistogram histogram = t.verdict().candidate_depth.histogram;
    EXPECT_EQ(histogram, BoundHistogram{});
}

TEST(Verdict, FramesOfAnotherSizeAreRefused) {
    TestScene t(Projection::parallel, 4, 4, {wall(4)});
    t.reference = Frame({4, 3});
    EXPECT_THROW(t.verdict(), std::invalid_argument);
    std::swap(t.candidate, t.reference);
    EXPECT_THROW(t.verdict(), std::invalid_argument);
    t.reference = Frame({4, 3});
    EXPECT_THROW(t.verdict(), std::invalid_argument);
}

TEST(Verdict, DoesNotDependOnTheNumberOfThreads) {
    const TestScene t = mixed_scene();
    const Verdict alone = tbb::task_arena(1).execute([&] { return t.verdict(); });
    const Verdict together = tbb::task_arena(3).execute([&] { return t.verdict(); });
    EXPECT_EQ(alone.counts, together.counts);
    EXPECT_EQ(alone.candidate_depth.histogram, together.candidate_depth.histogram);
    ASSERT_EQ(alone.findings.size(), together.findings.size());
    for (std::size_t i = 0; i < alone.findings.size(); ++i) {
        EXPECT_EQ(alone.findings[i].x, together.findings[i].x);
        EXPECT_EQ(alone.findings[i].eps_px, together.findings[i].eps_px);
    }
}

TEST(BoundRecord, CountsAnErrorIntoItsBin) {
    const auto bin_of = [](double error) {
        BoundRecord record;
        count(record, error);
        EXPECT_EQ(record.max_error_over_bound, error);
        return std::ranges::find(record.histogram, 1u) - record.histogram.begin();
    };
    EXPECT_EQ(bin_of(0), 0);
    EXPECT_EQ(bin_of(0.05), 1);
    EXPECT_EQ(bin_of(std::nextafter(0.05, 0)), 0);
    EXPECT_EQ(bin_of(0.975), 19);
    EXPECT_EQ(bin_of(1), 20);
    EXPECT_EQ(bin_of(1e300), 20);
}

TEST(BoundRecord, OfPartsIsTheirSum) {
    BoundRecord one, other, all;
    for (const double error : {0.1, 0.5, 3.0}) count(one, error), count(all, error);
    for (const double error : {0.5, 0.7}) count(other, error), count(all, error);
    add(one, other);
    EXPECT_EQ(one, all);
}

TEST(PixelClass, EverythingFromWrongAttributeOnFailsTheGate) {
    for (int c = 0; c < pixel_class_count; ++c) {
        Verdict verdict;
        verdict.counts[std::size_t(c)] = 3;
        EXPECT_EQ(defect_count(verdict), c >= int(PixelClass::wrong_attribute) ? 3u : 0u)
            << name_of(PixelClass(c));
    }
}

}  // namespace
}  // namespace zproof
