#include "lessons/depth/bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lessons/depth/scene_error.h"
#include "lessons/depth/study.h"
#include "scenes/suite.h"
#include "scenes/suite/random.h"

namespace zproof::study::depth {
namespace {

const Loaded& stage() {
    static const Loaded loaded = generate_suite_scene("depth_range", 160, 120);
    return loaded;
}

/// Near as the view has it: triangles reach behind it.
Seen seen_with(const Planes& planes) { return seen_in(stage().scene, stage().views.front(), planes); }

TEST(DepthBound, NoPixelOfAnyFormatAndInterpolationExceedsIt) {
    const Planes planes{0.01, 1e5};
    const Seen seen = seen_with(planes);
    ASSERT_GT(seen.pixels, 4000u);
    for (const Format& format : formats())
        for (const Interpolation interpolation : all_interpolations) {
            const ErrorSpread spread = error_spread(seen, format, interpolation, planes);
            EXPECT_LE(spread.largest_of_bound, 1) << format.name << " " << name_of(interpolation);
            EXPECT_EQ(spread.pixels, seen.pixels);
        }
}

// A bound that is never approached would prove little. Whole numbers spend half a step at their worst pixel.
TEST(DepthBound, IsReachedWhereTheStoreDecides) {
    const Planes planes{0.01, 1e5};
    const Seen seen = seen_with(planes);
    for (const char* name : {"z-unorm16", "w-unorm16", "log-unorm16"})
        EXPECT_GT(error_spread(seen, format_named(name), Interpolation::reciprocal, planes).largest_of_bound,
                  0.9)
            << name;
    EXPECT_GT(error_spread(seen, format_named("w-float32"), Interpolation::affine, planes).largest_of_bound,
              0.5);
}

TEST(DepthBound, AffineInterpolationErrsByTheDifferenceOfTheMeans) {
    // Half way along an edge from 1 to 9: (1 + 9) / 2 = 5 against 2 / (1 + 1/9) = 1.8.
    const Drawn edge{{glm::dvec2{0, 0}, glm::dvec2{100, 0}, glm::dvec2{0, 100}}, {1, 9, 1}};
    const Coder coder{format_named("w-float32"), {0.5, 16}};
    const std::vector<Pixel> middle{{49, 0}};
    const float wrong = interpolated(edge, middle, coder, Interpolation::affine).front();
    EXPECT_NEAR(coder.depth_of(wrong), 1 + 8 * 0.495, 1e-5);
    const float right = interpolated(edge, middle, coder, Interpolation::reciprocal).front();
    EXPECT_NEAR(coder.depth_of(right), 1 / (0.505 + 0.495 / 9), 1e-5);
}

TEST(DepthBound, NearIsCutAndWhatLiesBeforeItIsLeftOut) {
    const Seen all = seen_with({0.01, 1e5}), cut = seen_with({1, 1e5});
    EXPECT_GT(cut.left_out, all.left_out);
    EXPECT_GE(cut.nearest, 1);
    EXPECT_EQ(cut.pixels + cut.left_out, all.pixels + all.left_out);
    for (const Format& format : formats())
        EXPECT_LE(error_spread(cut, format, Interpolation::ndc, {1, 1e5}).largest_of_bound, 1) << format.name;
}

TEST(DepthGap, EveryMeasuredGapKeepsToThePrediction) {
    for (const double ratio : {10.0, 1e3, 1e7})
        for (const Format& format : formats()) {
            const GapCurve curve = gap_curve(format, Interpolation::reciprocal, {1, ratio}, 7);
            for (const GapAt& at : curve.points) {
                if (!std::isfinite(at.predicted)) continue;
                EXPECT_LE(at.measured, at.predicted) << format.name << " " << ratio << " " << at.depth;
                EXPECT_GE(at.measured, at.predicted / 32) << format.name << " " << ratio << " " << at.depth;
            }
        }
}

TEST(DepthGap, OfWholeNumbersIsAStep) {
    // Sixteen bits from 1 to 10: a step is 1/65535 of (1 - 1/d) 10/9, so at 5 it is 25 * 0.9 / 65535.
    const Coder coder{format_named("z-unorm16"), {1, 10}};
    EXPECT_NEAR(smallest_gap_behind(coder, Interpolation::reciprocal, 5), 25 * 0.9 / 65535, 1e-5);
    const Coder linear{format_named("w-unorm16"), {1, 10}};
    // And twice 9 float32 roundings of 5, and what comes after: 2 (45 + 2) 2^-24.
    EXPECT_NEAR(smallest_gap_behind(linear, Interpolation::reciprocal, 5), 9.0 / 65535, 94 * 0x1p-24 + 1e-6);
    EXPECT_NEAR(smallest_gap_before(linear, Interpolation::reciprocal, 5), 9.0 / 65535, 94 * 0x1p-24 + 1e-6);
}

TEST(DepthGap, ReversedFloatIsWorthItsNameOnlyInZeroToOne) {
    const Planes planes{1, 1e6};
    const double standard = worst_gap(format_named("z-float32"), planes);
    const double reversed = worst_gap(format_named("reversed-float32"), planes);
    const double in_gl = worst_gap(format_named("reversed-float32-gl"), planes);
    EXPECT_LT(reversed, 1e-4 * standard);
    EXPECT_GT(in_gl, 0.1 * standard);
}

TEST(DepthGap, NothingIsToldApartFarAwayIn16Bits) {
    const Coder coder{format_named("z-unorm16"), {1, 1e7}};
    EXPECT_TRUE(std::isinf(smallest_gap_behind(coder, Interpolation::reciprocal, 1e6)));
}

TEST(DepthFighting, GrowsAsTheLayersApproach) {
    const Planes planes{0.01, 1e5};
    const Seen seen = seen_with(planes);
    for (const Format& format : formats()) {
        EXPECT_EQ(fighting_share(seen, format, planes, 0), 1) << format.name << ": equal depths always fight";
        EXPECT_GE(fighting_share(seen, format, planes, seen.median * 0x1p-24),
                  fighting_share(seen, format, planes, seen.median))
            << format.name;
    }
    EXPECT_EQ(fighting_share(seen, format_named("log-float32"), planes, seen.farthest), 0);
}

TEST(DepthChoice, NamesTheFewestBitsThatDo) {
    const std::vector<WorstGap> gaps = worst_gaps({1, 10}, 1e-3);
    EXPECT_EQ(gaps.size(), formats().size());
    EXPECT_EQ(bits_of(gaps.front().format.store), 16);
    for (const WorstGap& one : gaps) EXPECT_EQ(one.holds, one.gap <= 1e-3) << one.format.name;
    EXPECT_TRUE(std::ranges::any_of(gaps, &WorstGap::holds));
}

TEST(DepthStudy, AParallelProjectionIsRefused) {
    const Loaded parallel = generate_suite_scene("orthographic", 64, 48);
    EXPECT_THROW(seen_in(parallel.scene, parallel.views.front(), {0.1, 10}), std::invalid_argument);
}

}  // namespace
}  // namespace zproof::study::depth
