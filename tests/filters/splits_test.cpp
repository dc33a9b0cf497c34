/// In a blend of two levels a card rounds the weights of all eight texels: what that may cost is admitted,
/// and no more.
#include <gtest/gtest.h>

#include <random>

#include "filters/commands/joint_check.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/reference/levels.h"
#include "scenes/filters/filter_scenes.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

namespace reference = oracle::filter_reference;
using reference::IntervalImage;

/// 1/256 of the whole, split as an NVIDIA H200 does; or rounded down.
int split(int share, int fraction, Rounding rounding) {
    return (share * fraction + (rounding == Rounding::nearest ? 128 : 0)) / 256;
}

/// A level's part of a blend, its share and the place in 1/256.
double part_of(const IntervalImage& level, int share, const glm::ivec2& place, Rounding rounding) {
    const glm::ivec2 before_centre = place - 128 + 4 * 256;  // four texels are a period of either level
    const int across = before_centre.x, down = before_centre.y, x = across % 256, y = down % 256;
    const int right = split(share, x, rounding), lower_right = split(right, y, rounding),
              upper_left = split(share - right, 256 - y, rounding);
    const std::array<int, 4> weights{upper_left, right - lower_right, share - right - upper_left,
                                     lower_right};
    double sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += weights[std::size_t(k)] / 256.0 *
               level.at((across / 256 + k % 2) % level.width, (down / 256 + k / 2) % level.height).value.r;
    return sum;
}

IntervalImage black_and_white(int side, std::mt19937& random) {
    IntervalImage image{side, side, {}, {}};
    for (int i = 0; i < side * side; ++i) image.texels.push_back({glm::dvec3{double(random() % 2)}, {}});
    return reference::with_range(std::move(image));
}

struct SplitTrial {
    int outside = 0;
    double most = 0;  ///< off the exact blend, in 2^-9
};

/// Blends at random with exact places and LODs, held to a promise of nothing but splits.
SplitTrial split_trial(Rounding rounding, double promised_bits) {
    std::mt19937 random{2026};
    const FilterPrecision exact, promise{.split_bits = promised_bits};
    SplitTrial trial;
    for (int texture = 0; texture < 40; ++texture) {
        const reference::Levels levels{{black_and_white(4, random), black_and_white(2, random)}, {}};
        for (int probe = 0; probe < 2000; ++probe) {
            const glm::ivec2 place{2 * int(random() % 512), 2 * int(random() % 512)};
            const int share = 1 + int(random() % 255);
            const double value = part_of(levels.at(0), 256 - share, place, rounding) +
                                 part_of(levels.at(1), share, place / 2, rounding);
            const reference::TexelInterval at{Interval{place.x / 256.0}, Interval{place.y / 256.0}};
            const ColourRange range = levels.trilinear(Interval{share / 256.0}, at, promise);
            trial.outside += value < range.low.r || value > range.high.r;
            const double middle = levels.trilinear(Interval{share / 256.0}, at, exact).low.r;
            trial.most = std::max(trial.most, std::abs(value - middle) * 0x1p9);
        }
    }
    return trial;
}

TEST(Splits, ToTheNearestOfEightBitsAreWithinNine) {
    const SplitTrial trial = split_trial(Rounding::nearest, 9);
    EXPECT_EQ(trial.outside, 0);
    EXPECT_GT(trial.most, 3.5) << "the promise is used";
}

TEST(Splits, AreNotWithinALittleMore) { EXPECT_GT(split_trial(Rounding::nearest, 9.02).outside, 0); }

TEST(Splits, RoundedDownAreWithinEightBitsOnly) {
    EXPECT_GT(split_trial(Rounding::down, 9).outside, 0);
    EXPECT_EQ(split_trial(Rounding::down, 8).outside, 0);
}

TEST(Splits, AreNoneWhereOneLevelIsRead) {
    std::mt19937 random{7};
    const reference::Levels levels{{black_and_white(4, random), black_and_white(2, random)}, {}};
    const reference::TexelInterval at{Interval{1.3}, Interval{2.2}};
    for (const double level : {0.0, 1.0}) {
        const ColourRange promised = levels.trilinear(Interval{level}, at, {.split_bits = 9}),
                          exact = levels.trilinear(Interval{level}, at, {});
        EXPECT_EQ(promised.low.r, exact.low.r);
        EXPECT_EQ(promised.high.r, exact.high.r);
    }
}

/// A place that may be anywhere permits any mean of the texels already.
TEST(Splits, CostNothingWhereAnyMeanIsPermitted) {
    std::mt19937 random{7};
    const reference::Levels levels{{black_and_white(4, random), black_and_white(2, random)}, {}};
    const reference::TexelInterval anywhere{Interval{-30, 30}, Interval{-30, 30}};
    const ColourRange range = levels.trilinear(Interval{0.5}, anywhere, {.split_bits = 9});
    EXPECT_EQ(range.low.r, 0);
    EXPECT_EQ(range.high.r, 1);
}

/// Where one level has equal texels and the other has not, as octaves of noise have.
class TunnelOfACard : public testing::Test {
  protected:
    TunnelOfACard() : loaded_(generate_filter_scene("tunnel", 256, 256)) {}

    std::uint64_t outside(const LimitedTrilinear& parts, const FilterPrecision& promise) const {
        const selftest::FilterFixture fixture{loaded_.scene, loaded_.views[0],
                                              oracle::exact_visibility(loaded_.scene, loaded_.views[0])};
        const Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                                     {.method = limited_trilinear(parts), .options = {}});
        return selftest::conformance_of(picture, fixture, {.method = "trilinear-gl", .precision = promise})
            .found.outside;
    }

  private:
    Loaded loaded_;
};

TEST_F(TunnelOfACard, KeepsThePromise) { EXPECT_EQ(outside(like_a_card(), gpu_with_exact_lod()), 0u); }

TEST_F(TunnelOfACard, DoesNotWhereSplitsArePromisedExact) {
    FilterPrecision promise = gpu_with_exact_lod();
    promise.split_bits = FilterPrecision::exact;
    EXPECT_GT(outside(like_a_card(), promise), 0u);
}

TEST_F(TunnelOfACard, DoesNotWhereSplitsHaveSevenBits) {
    LimitedTrilinear parts = like_a_card();
    parts.splits.bits = 7;
    EXPECT_GT(outside(parts, gpu_with_exact_lod()), 0u);
}

/// To the nearest, all to one side by as much, and the place within a level to the same side as well. Two
/// levels are read everywhere.
TEST(Splits, KeepTheJointPromise) {
    const selftest::FilterFixture ground = near_ground();
    const texture::FilterOptions two_levels{.lod_min = 0.25};
    const Lattice to_one_side{.offset = 0x1p-9};
    LimitedTrilinear nearest = like_a_card(), splits_aside = nearest, all_aside = nearest;
    splits_aside.splits = to_one_side;
    all_aside.splits = to_one_side, all_aside.weights = Lattice{.offset = 0x1p-8};
    FilterPrecision promise = gpu_with_exact_lod();
    promise.arithmetic_bits = promise.coordinate_bits = 53;
    for (LimitedTrilinear parts : {nearest, splits_aside, all_aside}) {
        parts.is_float32 = false;
        const Picture picture =
            rasterizer::filtered(ground.scene, ground.view, ground.frame,
                                 {.method = limited_trilinear(parts), .options = two_levels});
        const JointConformance found = joint_conformance_of(
            picture, ground, {.method = "trilinear-gl", .options = two_levels, .precision = promise});
        EXPECT_FALSE(found.leaves_promise()) << testing::PrintToString(in_words(found));
    }
}

}  // namespace
}  // namespace zproof
