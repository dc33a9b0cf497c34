// Two displaced bilinear reads: the table against the square, and lookups of it.
#include <gtest/gtest.h>

#include <cmath>

#include "filters/methods/catalogue.h"
#include "filters/methods/tap_rule.h"
#include "filters/stored/mip_chain.h"
#include "filters/stored/two_reads_table.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

const TwoReadsTable& table() {
    static const TwoReadsTable made;
    return made;
}

void for_each_entry(auto&& entry) {
    for (int side = TwoReadsTable::least_side; side <= TwoReadsTable::most_side; ++side)
        for (int row = 0; row < TwoReadsTable::cells; ++row)
            for (int column = 0; column < TwoReadsTable::cells; ++column)
                entry(side, glm::ivec2{column, row}, table().at(side, {column, row}));
}

/// Along one axis, of each 16th of a finer texel from 128 16ths before the coarser texel.
using Line = std::array<double, 320>;

Line line_between(double low, double high) {
    Line line{};
    for (int i = 0; i < 320; ++i)
        line[std::size_t(i)] =
            std::max(0.0, std::min(high, i - 127.0) - std::max(low, i - 128.0)) / (high - low);
    return line;
}

/// A bilinear read among texels of so many 16ths.
Line line_of_read(double place, double texel) {
    const double first = std::floor(place / texel - 0.5), share = place / texel - 0.5 - first;
    Line line = line_between(first * texel, (first + 1) * texel);
    const Line second = line_between((first + 1) * texel, (first + 2) * texel);
    for (std::size_t i = 0; i < line.size(); ++i) line[i] += share * (second[i] - line[i]);
    return line;
}

/// A product of two lines and its weight in a sum.
struct Term {
    double weight;
    Line across, down;
};

/// The square of a sum of terms, over the plane.
double squared(const std::vector<Term>& terms) {
    const auto product = [](const Line& a, const Line& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
        return sum;
    };
    double sum = 0;
    for (const Term& a : terms)
        for (const Term& b : terms)
            sum += a.weight * b.weight * product(a.across, b.across) * product(a.down, b.down);
    return sum;
}

Term read_term(double weight, const glm::dvec2& place, double texel) {
    return {weight, line_of_read(place.x, texel), line_of_read(place.y, texel)};
}

/// How far two reads, and how far trilinear-gl, is from the square of an entry's centre.
struct Distances {
    double two_reads, trilinear;

    Distances(int side, const glm::ivec2& cell, const TwoReads& reads) {
        const glm::dvec2 centre = 4.0 * glm::dvec2{cell} + 2.0, low = centre - double(side),
                         high = centre + double(side);
        const Term square{-1, line_between(low.x, high.x), line_between(low.y, high.y)};
        const double share = reads.share / 64.0, lod = std::log2(side / 8.0), level = std::floor(lod),
                     texel = 16 * std::exp2(level);
        two_reads = squared({square, read_term(share, centre + 2.0 * glm::dvec2{reads.finer}, 16),
                             read_term(1 - share, centre + 4.0 * glm::dvec2{reads.coarser}, 32)});
        trilinear = squared(
            {square, read_term(1 - (lod - level), centre, texel), read_term(lod - level, centre, 2 * texel)});
    }
};

/// Where the square is a texel of the finer level it is the bilinear read there, which is also nearest to it.
TEST(TwoReadsTable, IsTheFinerLevelsBilinearReadWhereTheSquareIsItsTexel) {
    for (int row = 0; row < TwoReadsTable::cells; ++row)
        for (int column = 0; column < TwoReadsTable::cells; ++column) {
            const TwoReads reads = table().at(8, {column, row});
            EXPECT_EQ(reads.share, 64);
            EXPECT_EQ(reads.finer, glm::ivec2(0));
        }
}

/// In the mean over all cells. A level further up texels are twice as wide, so trilinear's depend on which
/// half of one holds the cell.
TEST(TwoReadsTable, IsNearerToTheSquareThanTrilinearAtEverySide) {
    std::vector<double> two_reads(TwoReadsTable::most_side + 1), trilinear = two_reads;
    for_each_entry([&](int side, const glm::ivec2& cell, const TwoReads& reads) {
        for (const glm::ivec2 half :
             {glm::ivec2{0, 0}, glm::ivec2{8, 0}, glm::ivec2{0, 8}, glm::ivec2{8, 8}}) {
            const Distances found{side, cell + half, reads};
            two_reads[std::size_t(side)] += found.two_reads;
            trilinear[std::size_t(side)] += found.trilinear;
        }
    });
    EXPECT_DOUBLE_EQ(two_reads[8], trilinear[8]);  // both are bilinear
    for (std::size_t side = 9; side < two_reads.size(); ++side)
        EXPECT_LT(two_reads[side], (side < 16 ? 1 : 0.7) * trilinear[side]) << side;
}

/// No single step of a displacement or of the share makes an entry better.
TEST(TwoReadsTable, IsNotImprovedByOneStep) {
    for (const int side : {11, 16, 23, 32})
        for (const glm::ivec2 cell : {glm::ivec2{0, 0}, glm::ivec2{2, 3}, glm::ivec2{6, 1}}) {
            const TwoReads best = table().at(side, cell);
            const double least = Distances{side, cell, best}.two_reads;
            const auto expect_no_better = [&](const TwoReads& reads) {
                EXPECT_GE((Distances{side, cell, reads}.two_reads), least - 1e-12) << side;
            };
            for (const int step : {-1, 1}) {
                for (int axis = 0; axis < 2; ++axis) {
                    TwoReads other = best;
                    other.finer[axis] += step;
                    if (std::abs(other.finer[axis]) <= 16) expect_no_better(other);
                    other = best;
                    other.coarser[axis] += step;
                    if (std::abs(other.coarser[axis]) <= 4) expect_no_better(other);
                }
                TwoReads other = best;
                other.share = std::clamp(best.share + step, 0, 64);
                expect_no_better(other);
            }
        }
}

TEST(TwoReadsTable, IsMirroredInTheMiddleOfTheCoarserTexel) {
    for_each_entry([&](int side, const glm::ivec2& cell, const TwoReads& reads) {
        const TwoReads left = table().at(side, {7 - cell.x, cell.y}),
                       up = table().at(side, {cell.x, 7 - cell.y});
        EXPECT_EQ(
            left,
            (TwoReads{{-reads.finer.x, reads.finer.y}, {-reads.coarser.x, reads.coarser.y}, reads.share}));
        EXPECT_EQ(
            up,
            (TwoReads{{reads.finer.x, -reads.finer.y}, {reads.coarser.x, -reads.coarser.y}, reads.share}));
    });
}

Sampler prepared(const LinearImage& image) {
    return find_method("bilinear-reads-2")->prepare(image, {.mip_kernel = MipKernel::box});
}

glm::dvec4 bilinear_in(const LinearImage& image, const glm::dvec2& place) {
    glm::dvec4 sum{0};
    read_bilinear(image, {}, place, Tap{.image = 0, .weight = 1},
                  [&](const Tap& tap) { sum += tap.weight * glm::dvec4{image.at(tap.column, tap.row)}; });
    return sum;
}

double apart(const glm::dvec4& a, const glm::dvec4& b) { return glm::length(a - b); }

/// Levels of 16, 8, 4, 2 and 1 texels: the finer one read, the side in eighths of its texel, and the cell.
TEST(BilinearReads, ReadTheTableAtTheirSideAndCell) {
    const LinearImage image = random_image(16, 16, 6);
    const std::vector<LinearImage> chain = mip_chain(image, MipKernel::box);
    const auto expect = [&](const glm::dvec2& place, double step, std::size_t finer, int side,
                            glm::ivec2 cell) {
        const TwoReads reads = table().at(side, cell);
        const double size = double(1 << finer), share = reads.share / 64.0;
        const glm::dvec4 expected =
            share * bilinear_in(chain[finer], place / size + glm::dvec2{reads.finer} / 8.0) +
            (1 - share) * bilinear_in(chain[finer + 1], place / (2 * size) + glm::dvec2{reads.coarser} / 8.0);
        EXPECT_LE(apart(prepared(image).colour(flat_footprint(place, {step, 0}, {0, step / 2})), expected),
                  1e-14)
            << place.x << ", " << place.y << ", step " << step;
    };
    expect({5.3, 2.7}, 1.5, 0, 12, {5, 2});   // 5.3 is 2.65 coarser texels: the sixth eighth of the third
    expect({5.3, 2.7}, 1.56, 0, 12, {5, 2});  // 12.48 eighths
    expect({5.3, 2.7}, 1.57, 0, 13, {5, 2});  // 12.56
    expect({5.3, 2.7}, 3, 0, 24, {5, 2});     // LOD 1.58: still level 0
    expect({5.3, 2.7}, 5, 1, 20, {2, 5});     // LOD 2.32: levels 1 and 2; 1.325 and 0.675 coarser texels
    expect({-2.7, 21.3}, 5, 1, 20, {2, 2});   // -0.675 and 5.325
    expect({5.3, 2.7}, 15.9, 2, 32, {5, 2});  // LOD 3.99: levels 2 and 3
}

TEST(BilinearReads, ReadTheLastLevelAloneAtItsLod) {
    const LinearImage image = random_image(16, 8, 6);
    const std::vector<LinearImage> chain = mip_chain(image, MipKernel::box);
    for (const double step : {16.0, 100.0, 1e9})
        EXPECT_LE(apart(prepared(image).colour(flat_footprint({5.3, 2.7}, {step, 0}, {0, 1})),
                        glm::dvec4{chain.back().at(0, 0)}),
                  0x1p-50)
            << step;
}

TEST(BilinearReads, MakeWeightsOfSumOneNoneNegativeOfAtMostEightTexels) {
    const Sampler sampler = prepared(random_image(48, 33, 1));
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        double sum = 0;
        const std::vector<Tap> taps = sampler.taps(random_footprint(seed));
        for (const Tap& tap : taps) {
            EXPECT_GE(tap.weight, 0);
            sum += tap.weight;
        }
        EXPECT_NEAR(sum, 1, 0x1p-50) << seed;
        EXPECT_LE(taps.size(), 8u) << seed;
    }
}

TEST(BilinearReads, LeaveAConstantPictureAsItIs) {
    LinearImage grey = random_image(31, 8, 2);
    for (glm::vec4& texel : grey.texels) texel = glm::vec4{0.25f, 0.5f, 0.75f, 1};
    const Sampler sampler = prepared(grey);
    for (std::uint32_t seed = 0; seed < 200; ++seed)
        EXPECT_LE(apart(sampler.colour(random_footprint(seed)), glm::dvec4{0.25, 0.5, 0.75, 1}), 0x1p-50)
            << seed;
}

TEST(BilinearReads, OfATextureOfOneTexelAreIt) {
    const LinearImage image = random_image(1, 1, 3);
    EXPECT_LE(
        apart(prepared(image).colour(flat_footprint({0.3, 7.2}, {9, 0}, {0, 1})), glm::dvec4{image.at(0, 0)}),
        0x1p-50);
}

}  // namespace
}  // namespace zproof::texture
