#include "filters/stored/void_and_cluster.h"

#include <algorithm>
#include <vector>

#include "math/mixed.h"

namespace zproof::texture {
namespace {

constexpr int side = blue_noise_side, cells = side * side;

std::vector<std::uint64_t> weights_by_square() {
    constexpr std::uint64_t ratio = 3439140958;  // 2^32 exp(-1 / 4.5)
    std::vector<std::uint64_t> weights;
    for (std::uint64_t w = std::uint64_t{1} << 32; w > 0; w = (w * ratio) >> 32) weights.push_back(w);
    return weights;
}

/// Points on the torus, with every cell's sum of their weights.
class Points {
  public:
    bool holds(int cell) const { return is_point_[std::size_t(cell)]; }
    int count() const { return count_; }

    void put(int cell) { change(cell, true); }
    void take(int cell) { change(cell, false); }

    int tightest_cluster() const {
        return best([&](int a, int b) { return holds(a) && (!holds(b) || sum(a) > sum(b)); });
    }
    int largest_void() const {
        return best([&](int a, int b) { return !holds(a) && (holds(b) || sum(a) < sum(b)); });
    }
    std::uint64_t sum(int cell) const { return sums_[std::size_t(cell)]; }

  private:
    void change(int cell, bool becomes_point) {
        is_point_[std::size_t(cell)] = becomes_point;
        count_ += becomes_point ? 1 : -1;
        for (int y = -reach_; y <= reach_; ++y)
            for (int x = -reach_; x <= reach_; ++x) {
                const auto square = std::size_t(x * x + y * y);
                if (square >= weights_.size()) continue;
                const int row = (cell / side + y + side) % side, column = (cell % side + x + side) % side;
                std::uint64_t& sum = sums_[std::size_t(row * side + column)];
                sum = becomes_point ? sum + weights_[square] : sum - weights_[square];
            }
    }

    /// The first cell that no other one beats.
    template <class Beats>
    int best(const Beats& beats) const {
        int found = 0;
        for (int cell = 1; cell < cells; ++cell)
            if (beats(cell, found)) found = cell;
        return found;
    }

    std::vector<std::uint64_t> weights_ = weights_by_square();
    int reach_ = 9;  ///< beyond it weights are 0
    std::array<bool, cells> is_point_{};
    std::array<std::uint64_t, cells> sums_{};
    int count_ = 0;
};

Points spread_points() {
    Points points;
    for (int cell = 0; cell < cells; ++cell)
        if (mixed(std::uint64_t(cell)) % 8 == 0) points.put(cell);
    for (;;) {
        const int from = points.tightest_cluster();
        points.take(from);
        const int to = points.largest_void();
        const bool is_better = points.sum(to) < points.sum(from);
        points.put(is_better ? to : from);
        if (!is_better) return points;
    }
}

BlueNoiseRanks ranks_of(const Points& begun) {
    BlueNoiseRanks ranks{};
    for (Points points = begun; points.count() > 0;) {
        const int cell = points.tightest_cluster();
        points.take(cell);
        ranks[std::size_t(cell)] = std::uint16_t(points.count());
    }
    for (Points points = begun; points.count() < cells;) {
        const int cell = points.largest_void();
        ranks[std::size_t(cell)] = std::uint16_t(points.count());
        points.put(cell);
    }
    return ranks;
}

}  // namespace

const BlueNoiseRanks& blue_noise_ranks() {
    static const BlueNoiseRanks ranks = ranks_of(spread_points());
    return ranks;
}

}  // namespace zproof::texture
