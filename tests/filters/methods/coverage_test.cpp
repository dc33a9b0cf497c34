#include "texture/coverage.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "math/rounding.h"

namespace zproof::texture {
namespace {

using Weights = std::vector<double>;

/// Each texel's share of [low, high], texel by texel along the unwrapped line: the definition itself.
Weights by_brute_force(const Extent& extent, Wrap wrap, int size) {
    Weights weights(std::size_t(size), 0);
    for (double texel = std::floor(extent.low); texel < extent.high; ++texel) {
        const double inside = std::min(extent.high, texel + 1) - std::max(extent.low, texel);
        weights[std::size_t(wrapped(wrap, std::int64_t(texel), size))] += inside / (extent.high - extent.low);
    }
    return weights;
}

Weights of_runs(const Extent& extent, Wrap wrap, int size) {
    Weights weights(std::size_t(size), 0);
    const auto runs = covered(extent, wrap, size);
    for (const Run& run : runs.all())
        for (int texel = run.first; texel < run.last; ++texel) weights.at(std::size_t(texel)) += run.weight;
    return weights;
}

Weights of_prefixes(const Extent& extent, Wrap wrap, int size) {
    Weights weights(std::size_t(size), 0);
    const auto sums = prefixes(extent, wrap, size);
    for (const Prefix& prefix : sums.all())
        for (int texel = 0; texel < prefix.count; ++texel) weights.at(std::size_t(texel)) += prefix.weight;
    return weights;
}

/// A coordinate's rounding, over the interval's length, at either end and once more per period: 32 of them.
void expect_close(const Weights& expected, const Weights& found, const Extent& extent) {
    const double farthest = 1 + std::max(std::abs(extent.low), std::abs(extent.high)),
                 bound = 32 * unit_roundoff_float64 * farthest * farthest / (extent.high - extent.low);
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(expected[i], found[i], bound)
            << "texel " << i << " of " << extent.low << " to " << extent.high;
}

class Coverage : public testing::TestWithParam<Wrap> {};

TEST_P(Coverage, IsThatOfEveryTexelByItself) {
    std::mt19937 rng(5);
    std::uniform_real_distribution<double> place(-70, 70), length(0.01, 60);
    for (int trial = 0; trial < 20000 && !HasFailure(); ++trial) {
        const int size = 1 + int(rng() % 20);
        Extent extent{place(rng), 0};
        if (trial % 3 == 0)
            extent.low = std::floor(extent.low);  // ends on texels' edges, and on the texture's
        extent.high = extent.low + (trial % 5 == 0 ? double(1 + rng() % 40) : length(rng));
        const Weights expected = by_brute_force(extent, GetParam(), size);
        expect_close(expected, of_runs(extent, GetParam(), size), extent);
        expect_close(expected, of_prefixes(extent, GetParam(), size), extent);
    }
}

TEST_P(Coverage, OfRunsIsPositive) {
    for (double low = -9; low < 9; low += 0.125) {
        const auto runs = covered({low, low + 3.25}, GetParam(), 4);
        for (const auto& run : runs.all()) {
            EXPECT_GT(run.weight, 0);
            EXPECT_TRUE(0 <= run.first && run.first < run.last && run.last <= 4);
        }
    }
}

TEST_P(Coverage, StaysWithinTheTextureWhereCoordinatesAreAllRounding) {
    for (const double place : {1e15, -1e15, 0x1p50 + 0.5, 128.99999999999997, -129.00000000000003})
        for (const int size : {1, 129, 640}) {
            const auto runs = covered({place, place + 7}, GetParam(), size);
            for (const auto& run : runs.all())
                EXPECT_TRUE(0 <= run.first && run.first < run.last && run.last <= size) << place;
            const auto sums = prefixes({place, place + 7}, GetParam(), size);
            for (const Prefix& prefix : sums.all())
                EXPECT_TRUE(1 <= prefix.count && prefix.count <= size) << place;
        }
}

INSTANTIATE_TEST_SUITE_P(Wraps, Coverage,
                         testing::Values(Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat));

TEST(Coverage, OfWholeTexelsIsReadAsCrowReadsIt) {
    const auto reads = prefixes({3, 7}, Wrap::repeat, 16);
    double below = 0, above = 0;
    for (const Prefix& prefix : reads.all()) (prefix.count <= 3 ? below : above) += prefix.weight;
    EXPECT_EQ(above, 0.25);
    EXPECT_EQ(below, -0.25);
    EXPECT_EQ(reads.count, 4u);
    EXPECT_EQ(prefixes({0, 7}, Wrap::repeat, 16).count, 3u);    // no sum over no texel
    EXPECT_EQ(prefixes({13, 17}, Wrap::repeat, 16).count, 5u);  // and the whole row between
}

}  // namespace
}  // namespace zproof::texture
