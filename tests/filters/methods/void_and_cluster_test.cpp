// The mask has the property that makes its noise blue.
#include "filters/stored/void_and_cluster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace zproof::texture {
namespace {

constexpr int side = blue_noise_side, cells = side * side;

std::uint64_t weight_of(int square) {
    std::uint64_t weight = std::uint64_t{1} << 32;
    for (int i = 0; i < square; ++i) weight = weight * 3439140958 >> 32;
    return weight;
}

int square_of_distance(int a, int b) {
    const auto along = [](int way) { return std::min(std::abs(way), side - std::abs(way)); };
    const int x = along(a % side - b % side), y = along(a / side - b / side);
    return x * x + y * y;
}

/// The sum that points of a lesser rank than `count` have at every cell.
std::vector<std::uint64_t> sums_of_first(int count) {
    std::vector<std::uint64_t> weights;
    for (int square = 0; square <= side * side / 2; ++square) weights.push_back(weight_of(square));
    std::vector<std::uint64_t> sums(cells);
    for (int point = 0; point < cells; ++point)
        if (blue_noise_ranks()[std::size_t(point)] < count)
            for (int cell = 0; cell < cells; ++cell)
                sums[std::size_t(cell)] += weights[std::size_t(square_of_distance(point, cell))];
    return sums;
}

TEST(BlueNoise, RanksEveryCellOnce) {
    std::vector<int> ranks(blue_noise_ranks().begin(), blue_noise_ranks().end());
    std::ranges::sort(ranks);
    std::vector<int> all(cells);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(ranks, all);
}

/// What makes it void-and-cluster, by sums of its own: the next point is the largest void of those before it.
/// Below the points that it began with, it is the tightest cluster of those up to it.
TEST(BlueNoise, PutsEachPointIntoTheLargestVoid) {
    for (const int rank : {600, 1000, 2048, 3000, 4000}) {
        const std::vector<std::uint64_t> sums = sums_of_first(rank);
        std::uint64_t least = std::numeric_limits<std::uint64_t>::max(), own = 0;
        for (int cell = 0; cell < cells; ++cell) {
            if (blue_noise_ranks()[std::size_t(cell)] < rank) continue;
            least = std::min(least, sums[std::size_t(cell)]);
            if (blue_noise_ranks()[std::size_t(cell)] == rank) own = sums[std::size_t(cell)];
        }
        EXPECT_EQ(own, least) << rank;
    }
    for (const int rank : {10, 100, 400}) {
        const std::vector<std::uint64_t> sums = sums_of_first(rank + 1);
        std::uint64_t most = 0, own = 0;
        for (int cell = 0; cell < cells; ++cell) {
            if (blue_noise_ranks()[std::size_t(cell)] > rank) continue;
            most = std::max(most, sums[std::size_t(cell)]);
            if (blue_noise_ranks()[std::size_t(cell)] == rank) own = sums[std::size_t(cell)];
        }
        EXPECT_EQ(own, most) << rank;
    }
}

/// Mean power of a threshold at the frequencies below a quarter of the highest, as a share of white noise's:
/// a permutation of the ranks has the same at each frequency on the average.
TEST(BlueNoise, HasLittlePowerAtLowFrequencies) {
    std::vector<std::complex<double>> turns;
    for (int i = 0; i < side; ++i) turns.push_back(std::polar(1.0, 2 * std::numbers::pi * i / side));
    double power = 0;
    int frequencies = 0;
    for (int v = -side / 8; v <= side / 8; ++v)
        for (int u = -side / 8; u <= side / 8; ++u) {
            if ((u == 0 && v == 0) || u * u + v * v > side * side / 64) continue;
            std::complex<double> sum = 0;
            for (int cell = 0; cell < cells; ++cell) {
                const int turn = (u * (cell % side) + v * (cell / side)) & (side - 1);
                sum += double(blue_noise_ranks()[std::size_t(cell)]) * turns[std::size_t(turn)];
            }
            power += std::norm(sum);
            ++frequencies;
        }
    const double white = cells * (double(cells) * cells - 1) / 12;  // cells x variance of 0 .. cells - 1
    EXPECT_LT(power / frequencies, white / 10);
}

}  // namespace
}  // namespace zproof::texture
