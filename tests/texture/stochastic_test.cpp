// Methods that draw texels, by how often they draw which.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/footprints.h"
#include "texture/catalogue.h"

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

}  // namespace
}  // namespace zproof::texture
