// Cardinality-constrained filters at places whose texels and weights are worked by hand.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/footprints.h"
#include "texture/catalogue.h"

namespace zproof::texture {
namespace {

Sampler prepared(const char* name, const LinearImage& image) { return find_method(name)->prepare(image, {}); }

double distance(const glm::dvec4& a, const glm::dvec4& b) { return glm::length(a - b); }

/// The taps of cardinality-4 where the square is 2 texels wide, of 64 x 64. Weights are in 1024ths.
void expect_four(const glm::dvec2& place, const std::vector<Tap>& expected) {
    const std::vector<Tap> taps =
        prepared("cardinality-4", random_image(64, 64, 8)).taps(flat_footprint(place, {1.99, 0}, {0, 1.5}));
    ASSERT_EQ(taps.size(), expected.size());
    for (std::size_t i = 0; i < taps.size(); ++i) {
        EXPECT_EQ(std::tie(taps[i].image, taps[i].column, taps[i].row),
                  std::tie(expected[i].image, expected[i].column, expected[i].row));
        EXPECT_NEAR(taps[i].weight, expected[i].weight / 1024, 1e-15);
    }
}

/// About 15/16 of the first texel of two the square covers 1/16, 1 and 15/16 of three texels along either
/// axis. Best is the coarser texel, the mean 961/4 of 256, 240, 240 and 225 1024ths. Then 256 by itself,
/// which leaves the mean 235; then the 16 above and the 16 on the left. What is missing, 15 + 15 + 1, is
/// spread over the six texels that are covered.
TEST(Cardinality, ChoosesAndWeighsFourTexelsAsItsCardSays) {
    const double spread = 31 / 6.0;
    expect_four({10 + 15 / 16.0, 18 + 15 / 16.0}, {{1, 5, 9, 4 * (235 + spread)},
                                                   {0, 10, 17, 16 + spread},
                                                   {0, 9, 18, 16 + spread},
                                                   {0, 10, 18, 256 - 235}});
}

/// A texel to the right the coarser one has 16, 256, 15 and 240, which takes 527^2 / 4 off the squares; next
/// are 240 and 225 beside it, and 256 by itself. What is missing is 1 + 16 + 15 above.
TEST(Cardinality, KnowsInWhichHalfOfACoarserTexelItsPlaceLies) {
    const double rest = (16 + 15 + 240) / 3.0, spread = 32 / 6.0;
    expect_four({11 + 15 / 16.0, 18 + 15 / 16.0}, {{1, 5, 9, 4 * (rest + spread)},
                                                   {0, 11, 18, 256 - rest},
                                                   {0, 12, 18, 240 + spread},
                                                   {0, 12, 19, 225 + spread}});
}

/// In the first of these places eight texels make all nine, since 240 stands twice under the coarser one.
TEST(Cardinality, OfEightTexelsIsTheMeanWhereTheyMakeIt) {
    const LinearImage image = random_image(64, 64, 8);
    const Footprint f = flat_footprint({10 + 15 / 16.0, 18 + 15 / 16.0}, {1.99, 0}, {0, 1.5});
    const int covered[] = {1, 16, 15};
    glm::dvec4 mean{0};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            mean += covered[column] * covered[row] / 1024.0 * glm::dvec4{image.at(9 + column, 17 + row)};
    const Sampler sampler = prepared("cardinality-8", image);
    EXPECT_EQ(sampler.taps(f).size(), 8u);
    EXPECT_LE(distance(sampler.colour(f), mean), 0x1p-24 + 0x1p-50);  // of level 1, to float32
}

TEST(Cardinality, OfSideOneIsBilinearInTheMiddleOfItsCell) {
    const LinearImage image = random_image(64, 64, 8);
    const Footprint f = flat_footprint({10.06, 20.9}, {0.5, 0}, {0, 0.5}),
                    there = flat_footprint({10.0625, 20.9375}, {0.5, 0}, {0, 0.5});
    for (const char* name : {"cardinality-4", "cardinality-8"})
        EXPECT_LE(distance(prepared(name, image).colour(f), prepared("bilinear", image).colour(there)),
                  0x1p-50)
            << name;
}

TEST(Cardinality, ReadsNoMoreTexelsThanItsNameSays) {
    const LinearImage image = random_image(48, 33, 1);
    const Sampler four = prepared("cardinality-4", image), eight = prepared("cardinality-8", image);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        EXPECT_LE(four.taps(random_footprint(seed)).size(), 4u) << seed;
        EXPECT_LE(eight.taps(random_footprint(seed)).size(), 8u) << seed;
    }
}

}  // namespace
}  // namespace zproof::texture
