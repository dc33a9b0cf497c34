// Methods that draw texels, by how often they draw which.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "filters/methods/catalogue.h"
#include "filters/stored/void_and_cluster.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

Sampler stochastic(const char* name, const LinearImage& image, const FilterOptions& options) {
    return find_method(name)->prepare(image, options);
}

/// How far a share of so many independent decisions lies from its probability, once in 10^9 (Hoeffding 1963).
double by_chance(double decisions) { return std::sqrt(std::log(2e9) / (2 * decisions)); }

/// A place of (1.75, 2): columns 1 and 2 by 3/4 and 1/4, rows 1 and 2 by halves.
TEST(Stochastic, DrawsATexelWithTheProbabilityOfItsWeight) {
    const LinearImage image = random_image(4, 4, 1);
    const Footprint f = flat_footprint({1.75, 2}, {1, 0}, {0, 1});
    constexpr int seeds = 40'000;
    std::map<std::pair<int, int>, int> drawn;
    for (std::uint32_t seed = 0; seed < seeds; ++seed)
        for (const Tap& tap : stochastic("stochastic-bilinear", image, {.seed = seed}).taps(f))
            ++drawn[{tap.column, tap.row}];
    EXPECT_EQ(drawn.size(), 4u);
    for (const int row : {1, 2}) {
        EXPECT_NEAR((drawn[{1, row}]) / double(seeds), 3 / 8.0, by_chance(seeds));
        EXPECT_NEAR((drawn[{2, row}]) / double(seeds), 1 / 8.0, by_chance(seeds));
    }
}

/// LOD 1/4: the coarser level once in four.
TEST(Stochastic, DrawsALevelWithTheProbabilityOfItsShare) {
    const double step = std::exp2(0.25);
    const Footprint f = flat_footprint({1.75, 2}, {step, 0}, {0, step});
    constexpr int seeds = 10'000;
    int coarser = 0;
    const LinearImage image = random_image(4, 4, 1);
    for (std::uint32_t seed = 0; seed < seeds; ++seed)
        coarser += stochastic("stochastic-trilinear", image, {.seed = seed}).taps(f).front().image;
    EXPECT_NEAR(coarser / double(seeds), 0.25, by_chance(seeds));
}

/// In every pixel and of every sample anew: a column of probability 1/2 in two of two samples once in four.
TEST(Stochastic, DecidesEverySampleAndPixelByItself) {
    const Sampler sampler = stochastic("stochastic-bilinear", random_image(4, 4, 1), {.samples = 2});
    constexpr int side = 120;
    int first = 0, both = 0, like_the_last = 0;
    bool last = false;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::vector<Tap> taps =
                sampler.taps({.centre = {2, 2}, .centre_raster = {x + 0.5, y + 0.5}});
            ASSERT_EQ(taps.size(), 2u);
            EXPECT_EQ(taps[0].weight, 0.5);
            const bool a = taps[0].column == 2, b = taps[1].column == 2;
            first += a, both += a && b, like_the_last += a == last;
            last = a;
        }
    constexpr double pixels = side * side;
    EXPECT_NEAR(first / pixels, 0.5, by_chance(pixels));
    EXPECT_NEAR(both / pixels, 0.25, by_chance(pixels));
    EXPECT_NEAR(like_the_last / pixels, 0.5, by_chance(pixels));
}

struct Drawn {
    int level, column, row;
    bool operator==(const Drawn&) const = default;
};

/// What pixel (x, y) draws of a texture of 4 x 4 at the place (1.75, 2), with steps of 2^lod texels.
Drawn drawn_by(const char* method, int x, int y, std::uint32_t frame, double lod) {
    Footprint f = flat_footprint({1.75, 2}, {std::exp2(lod), 0}, {0, std::exp2(lod)});
    f.centre_raster = {x + 0.5, y + 0.5};
    const Tap tap = stochastic(method, random_image(4, 4, 1), {.seed = frame}).taps(f).front();
    return {tap.image, tap.column, tap.row};
}

Drawn interleaved(int x, int y, std::uint32_t frame, double lod) {
    return drawn_by("stochastic-interleaved", x, y, frame, lod);
}

/// Columns 1 and 2 by 3/4 and 1/4, rows 1 and 2 by halves. The noise is 0 at (0, 0), 0.5557 at (1, 0), 0.3093
/// at (0, 1), 0.8178 at (7, 3) and 0.1542 at (1, 0) a frame later.
TEST(Interleaved, DecidesByOneNumberOfPixelAndFrame) {
    EXPECT_EQ(interleaved(0, 0, 0, 0), (Drawn{0, 2, 2}));
    EXPECT_EQ(interleaved(1, 0, 0, 0), (Drawn{0, 1, 2}));  // (0.5557 - 1/4) / (3/4) = 0.408
    EXPECT_EQ(interleaved(0, 1, 0, 0), (Drawn{0, 1, 2}));  // 0.079
    EXPECT_EQ(interleaved(7, 3, 0, 0), (Drawn{0, 1, 1}));  // 0.757
    EXPECT_EQ(interleaved(1, 0, 1, 0), (Drawn{0, 2, 1}));  // 0.1542 / (1/4) = 0.617
    EXPECT_EQ(interleaved(1, 0, 65, 0), interleaved(1, 0, 1, 0));
}

/// LOD 1/4: the level comes first. In level 1 of 2 x 2 texels the place is (0.875, 1): columns 0 and 1 by 5/8
/// and 3/8.
TEST(Interleaved, DecidesTheLevelFirst) {
    EXPECT_EQ(interleaved(1, 0, 0, 0.25), (Drawn{0, 1, 2}));  // 0.408, then (0.408 - 1/4) / (3/4) = 0.210
    EXPECT_EQ(interleaved(1, 0, 1, 0.25), (Drawn{1, 0, 1}));  // 0.617, then (0.617 - 3/8) / (5/8) = 0.387
}

/// How far the mean of 3 x 3 pixels lies from the expectation 1/4, root mean square: with white noise
/// sqrt(3/16 / 9).
TEST(Interleaved, IsEvenerOverNeighboursThanWhiteNoise) {
    double squares = 0;
    int blocks = 0;
    for (int y = 0; y < 60; y += 3)
        for (int x = 0; x < 60; x += 3) {
            int second = 0;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) second += interleaved(x + i, y + j, 0, 0).column == 2;
            squares += (second / 9.0 - 0.25) * (second / 9.0 - 0.25);
            ++blocks;
        }
    EXPECT_LT(std::sqrt(squares / blocks), 0.5 * std::sqrt(3 / 16.0 / 9));
}

/// Columns 1 and 2 by 3/4 and 1/4, rows 1 and 2 by halves. A rank below 1024 has column 2, and then row 2
/// below 512; other ranks have column 1, and row 2 below 1024 + 1536. A frame later 0.618 is added.
TEST(Blue, DecidesByTheRankOfThePixel) {
    const auto expected = [](double number) {
        if (number < 0.25) return Drawn{0, 2, number < 0.125 ? 2 : 1};
        return Drawn{0, 1, number < 0.625 ? 2 : 1};
    };
    for (int y = 0; y < 70; y += 3)
        for (int x = 0; x < 70; ++x) {
            const double number = (blue_noise_ranks()[std::size_t(y % 64 * 64 + x % 64)] + 0.5) / 4096;
            EXPECT_EQ(drawn_by("stochastic-blue", x, y, 0, 0), expected(number)) << x << " " << y;
            const double next = number + (std::sqrt(5.0) - 1) / 2;
            EXPECT_EQ(drawn_by("stochastic-blue", x, y, 1, 0), expected(next - std::floor(next)));
        }
}

}  // namespace
}  // namespace zproof::texture
