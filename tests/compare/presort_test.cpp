/// Pixels that are settled by tolerances must be judged as those that are not: histograms want every ratio,
/// so judge_with_histograms() and judge_in_full() settle none so.
#include "compare/first_pass/presort.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/first_pass/agreement.h"
#include "compare/judge.h"
#include "compare/truth/depth_bound.h"
#include "compare/witness.h"
#include "random_surroundings.h"
#include "stage.h"
#include "tests/support/same_verdict.h"

namespace zproof {
namespace {

constexpr int width = 70, height = 20;

/// Runs of pixels that show one of a few walls, each depth off by a share of what is lawful, or nothing. Half
/// of the frames have few depths of each wall, half of them so many runs that those are looked at by
/// themselves; a third show each wall everywhere at the depth that it has in the middle.
void show_runs(Frame& frame, Dice& dice, const View& view, const Scene& scene) {
    const double most_off = std::ldexp(1.0, -26 + dice.below(7));
    const bool has_few = dice.below(2) == 0;
    const auto off = [&] {
        return has_few ? most_off * (dice.below(12) - 5.5) / 5.5 : dice.between(-most_off, most_off);
    };
    std::uint32_t triangle = 0;
    const int longest = dice.below(2) != 0 ? 6 : 2;
    const bool is_stuck = dice.below(3) == 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (dice.below(longest) == 0)
                triangle = std::uint32_t(dice.below(int(scene.triangles.size()) + 1));
            if (triangle == scene.triangles.size()) {
                if (dice.below(40) == 0) answer(frame, x, y, triangle, 8);  // nobody's
                continue;                                                   // bare
            }
            const auto image =
                image_of(is_stuck ? Sight<double>(view, width / 2, height / 2) : Sight<double>(view, x, y),
                         corners<double>(corners_of(scene, triangle)));
            if (!image) continue;
            const double n = image->nearness.c;
            const double depth = view.camera.projection == Projection::perspective ? 1 / n : -n;
            answer(frame, x, y, triangle, depth * (1 + off()));
        }
}

std::uint64_t number(const BoundRecord& record, std::size_t first_bin) {
    std::uint64_t sum = 0;
    for (std::size_t i = first_bin; i < record.histogram.size(); ++i) sum += record.histogram[i];
    return sum;
}

/// A few walls, and two frames that show runs of them.
struct Shown {
    Dice dice;
    View view;
    Scene scene;
    Frame candidate, reference;

    explicit Shown(std::uint32_t seed)
        : dice(seed),
          view(pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, width, height)),
          scene(random_walls(dice, view)),
          candidate({width, height}),
          reference({width, height}) {
        show_runs(candidate, dice, view, scene);
        if (dice.below(2) != 0)
            reference = candidate;  // whole chunks of the same
        else
            show_runs(reference, dice, view, scene);
        if (dice.below(2) != 0) blur(reference);
    }

    /// Other depths of the same triangles.
    void blur(Frame& frame) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                float& depth = frame.camera_depth.at(x, y);
                depth = float(depth * (1 + dice.between(-1, 1) * 0x1p-24));
            }
    }
};

TEST(Presort, JudgesEveryPixelAsInFull) {
    std::uint64_t right = 0, wrong = 0, invalid = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const auto& [dice, view, scene, candidate, reference] = Shown(seed);
        RenderedFrame ours{candidate, raster_precision()}, theirs{reference, ray_precision()};
        if (seed % 2 != 0) std::swap(ours.precision, theirs.precision);
        const Verdict in_full = judge_in_full(scene, view, ours, theirs).verdict,
                      verdict = judge(scene, view, ours, theirs),
                      with_histograms = judge_with_histograms(scene, view, ours, theirs);
        expect_same_counts(verdict, in_full);
        EXPECT_EQ(verdict.candidate_depth.histogram, BoundHistogram{});
        EXPECT_EQ(verdict.reference_depth.histogram, BoundHistogram{});
        expect_same_counts(with_histograms, in_full);
        expect_same_histograms(with_histograms, in_full);
        right += number(in_full.candidate_depth, 1) - number(in_full.candidate_depth, 20);
        wrong += number(in_full.candidate_depth, 20);
        invalid += verdict.counts[std::size_t(PixelClass::invalid)];
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(right, 10'000u) << "lawful, and not in the first bin";
    EXPECT_GT(wrong, 1'000u);
    EXPECT_GT(invalid, 300u);
}

/// Of one renderer's depths at pixels at which both name the same triangle, asked one by one.
BoundRecord record_of(const Scene& scene, const View& view, const RenderedFrame& whose, const RenderedFrame& other) {
    const ViewBounds bounds(view, whose.precision);
    std::vector<TriangleDepth> depths;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
        depths.push_back(depth_of(TriangleInView(view, bounds, corners_of(scene, t)), bounds));
    BoundRecord record;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Answer answer{whose.frame.primitive.at(x, y), whose.frame.camera_depth.at(x, y)},
                others{other.frame.primitive.at(x, y), other.frame.camera_depth.at(x, y)};
            const auto shown = std::size_t(answer.primitive);
            if (answer.primitive != others.primitive || shown >= depths.size() ||
                is_invalid(answer, depths.size()) || is_invalid(others, depths.size()))
                continue;
            count(record, error_over_bound(depths[shown].at(x, y), answer.camera_depth));
        }
    return record;
}

TEST(Histograms, AreOfEveryPixelThatBothNameAlike) {
    std::uint64_t lawful = 0, wrong = 0;  // the reference's
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const auto& [dice, view, scene, candidate, reference] = Shown(seed);
        const RenderedFrame ours{candidate, raster_precision()},
            theirs{reference, seed % 2 ? raster_precision() : ray_precision()};
        const Verdict verdict = judge_with_histograms(scene, view, ours, theirs);
        EXPECT_EQ(verdict.candidate_depth, record_of(scene, view, ours, theirs));
        EXPECT_EQ(verdict.reference_depth, record_of(scene, view, theirs, ours));
        lawful += number(verdict.reference_depth, 0) - number(verdict.reference_depth, 20);
        wrong += number(verdict.reference_depth, 20);
    }
    EXPECT_GT(lawful, 5'000u);
    EXPECT_GT(wrong, 500u);
}

}  // namespace
}  // namespace zproof
