// Tables of few texels, and lookups of them, where the answer is known by hand.
#include <gtest/gtest.h>

#include "filters/methods/catalogue.h"
#include "filters/stored/cardinality_table.h"
#include "filters/stored/mip_chain.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

const CardinalityTable& of_four() {
    static const CardinalityTable table{4};
    return table;
}

struct Expected {
    int level, column, row;
    double weight;
};

/// In any order; a millionth of |w|^2 in the balance moves weights by little more.
void expect_taps(int u, int v, int lod, const std::vector<Expected>& expected) {
    SCOPED_TRACE(testing::Message() << u << ", " << v << ", lod " << lod);
    const auto taps = of_four().at(u, v, lod);
    EXPECT_EQ(taps.size(), expected.size());
    for (const Expected& e : expected) {
        double weight = 0;
        for (const TableTap& tap : taps)
            if (tap.level == e.level && tap.column == e.column && tap.row == e.row) weight = tap.weight;
        EXPECT_NEAR(weight, e.weight, 0x1p-18) << e.level << ": " << e.column << ", " << e.row;
    }
}

/// At LOD 0 the pixel is as large as a texel of the finest level.
TEST(CardinalityTable, TakesTheTexelThatThePixelIs) {
    expect_taps(4, 4, 0, {{0, 0, 0, 1}});
    expect_taps(12, 28, 0, {{0, 0, 0, 1}});
    expect_taps(8, 8, 8, {{1, 0, 0, 1}});  // texels of level 1 are 16 places wide
    expect_taps(24, 8, 8, {{1, 0, 0, 1}});
}

TEST(CardinalityTable, SharesThePixelAmongTheTexelsThatItCovers) {
    expect_taps(6, 4, 0, {{0, 0, 0, 0.75}, {0, 1, 0, 0.25}});
    expect_taps(0, 0, 0, {{0, -1, -1, 0.25}, {0, 0, -1, 0.25}, {0, -1, 0, 0.25}, {0, 0, 0, 0.25}});
    expect_taps(16, 16, 8, {{0, -1, -1, 0.25}, {0, 0, -1, 0.25}, {0, -1, 0, 0.25}, {0, 0, 0, 0.25}});
    expect_taps(16, 8, 8, {{0, -1, -1, 0.25}, {0, 0, -1, 0.25}, {0, -1, 0, 0.25}, {0, 0, 0, 0.25}});
    expect_taps(14, 5, 0, {{0, 0, 0, 0.65625}, {0, 1, 0, 0.21875}, {0, 0, 1, 0.09375}, {0, 1, 1, 0.03125}});
}

/// Where one texel of level 1 is those four, an eighth of it takes the place of the last, and the same share
/// of the others.
TEST(CardinalityTable, TakesACoarserTexelForASharedRest) {
    expect_taps(6, 5, 0, {{1, 0, 0, 0.125}, {0, 0, 0, 0.625}, {0, 1, 0, 0.1875}, {0, 0, 1, 0.0625}});
}

TEST(CardinalityTable, HasWeightsOfSumOneAndNoMoreTexelsThanItMay) {
    for (int lod = 0; lod < CardinalityTable::lods; ++lod)
        for (int v = 0; v < CardinalityTable::places; ++v)
            for (int u = 0; u < CardinalityTable::places; ++u) {
                double sum = 0;
                for (const TableTap& tap : of_four().at(u, v, lod)) sum += tap.weight;
                ASSERT_NEAR(sum, 1, 0x1p-48);
                ASSERT_LE(of_four().at(u, v, lod).size(), 4u);
            }
}

glm::dvec4 read(const LinearImage& image, const glm::dvec2& place, double step) {
    return find_method("cardinality-4")
        ->prepare(image, {.mip_kernel = MipKernel::box})
        .colour(flat_footprint(place, {step, 0}, {0, step}));
}

double apart(const glm::dvec4& a, const glm::dvec4& b) {
    const glm::dvec4 d = glm::abs(a - b);
    return std::max(std::max(d.x, d.y), std::max(d.z, d.w));
}

/// Levels of 16, 8, 4, 2 and 1 texels.
TEST(Cardinality, ReadsTheTableAtTheNearestPlaceAndLod) {
    const LinearImage image = random_image(16, 16, 6);
    const std::vector<LinearImage> chain = mip_chain(image, MipKernel::box);
    const auto texel = [&](std::size_t level, int column, int row) {
        return glm::dvec4{chain[level].at(column, row)};
    };
    EXPECT_LE(apart(read(image, {5.5, 3.5}, 1), texel(0, 5, 3)), 1e-15);
    EXPECT_LE(apart(read(image, {5.55, 3.45}, 1.04), texel(0, 5, 3)), 1e-15);  // within 1/16 of either
    EXPECT_GT(apart(read(image, {5.5, 3.5}, 1.07), texel(0, 5, 3)), 1e-3);     // 0.8 eighths: a wider box
    EXPECT_LE(apart(read(image, {7, 5}, 2), texel(1, 3, 2)), 1e-15);
    EXPECT_LE(apart(read(image, {-9, 37}, 2), texel(1, 3, 2)), 1e-15);
    EXPECT_LE(apart(read(image, {6, 14}, 4), texel(2, 1, 3)), 1e-15);
    EXPECT_LE(apart(read(image, {3.3, 14}, 100), texel(4, 0, 0)), 1e-15);
    EXPECT_LE(apart(read(image, {6.75, 2.5}, 1), 0.75 * texel(0, 6, 2) + 0.25 * texel(0, 7, 2)), 0x1p-18);
}

TEST(Cardinality, ReadsNoMoreTexelsThanItsNameSays) {
    const LinearImage image = random_image(48, 33, 1);
    const Sampler four = find_method("cardinality-4")->prepare(image, {}),
                  eight = find_method("cardinality-8")->prepare(image, {});
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        EXPECT_LE(four.taps(random_footprint(seed)).size(), 4u) << seed;
        EXPECT_LE(eight.taps(random_footprint(seed)).size(), 8u) << seed;
    }
}

}  // namespace
}  // namespace zproof::texture
