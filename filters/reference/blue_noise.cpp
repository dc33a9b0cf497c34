#include "filters/reference/blue_noise.h"

#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

#include "math/mixed.h"

namespace zproof::oracle::filter_reference {

namespace {

constexpr int cell_count = mask_side * mask_side;

/// Points and empty cells, both kept in the order of their sums.
class Mask {
  public:
    Mask() : energy_(cell_count), is_set_(cell_count) {
        for (int cell = 0; cell < cell_count; ++cell) empty_.emplace(0, cell);
        constexpr std::uint64_t one = std::uint64_t{1} << 32;
        for (std::uint64_t w = one; w > 0; w = w * 3439140958 / one) kernel_.push_back(std::int64_t(w));
    }

    int size() const { return int(set_.size()); }
    std::int64_t energy(int cell) const { return energy_[std::size_t(cell)]; }
    int largest_void() const { return empty_.begin()->second; }
    /// The first of the points of the greatest sum.
    int tightest() const { return set_.lower_bound({set_.rbegin()->first, 0})->second; }

    void toggle(int cell) {
        const bool leaves = is_set_[std::size_t(cell)];
        order_of(cell).erase({energy(cell), cell});
        is_set_[std::size_t(cell)] = !leaves;
        order_of(cell).emplace(energy(cell), cell);
        for (int other = 0; other < cell_count; ++other) {
            const auto d2 = std::size_t(squared_distance(cell, other));
            if (d2 < kernel_.size()) add(other, leaves ? -kernel_[d2] : kernel_[d2]);
        }
    }

  private:
    using Order = std::set<std::pair<std::int64_t, int>>;

    Order& order_of(int cell) { return is_set_[std::size_t(cell)] ? set_ : empty_; }

    void add(int cell, std::int64_t more) {
        order_of(cell).erase({energy(cell), cell});
        energy_[std::size_t(cell)] += more;
        order_of(cell).emplace(energy(cell), cell);
    }

    static int squared_distance(int a, int b) {
        const auto along = [](int p, int q) {
            const int way = std::abs(p - q);
            return way > mask_side / 2 ? mask_side - way : way;
        };
        const int dx = along(a % mask_side, b % mask_side), dy = along(a / mask_side, b / mask_side);
        return dx * dx + dy * dy;
    }

    std::vector<std::int64_t> energy_, kernel_;
    std::vector<bool> is_set_;
    Order set_, empty_;
};

Mask relaxed_mask() {
    Mask mask;
    for (int cell = 0; cell < cell_count; ++cell)
        if (mixed(std::uint64_t(cell)) % 8 == 0) mask.toggle(cell);
    for (bool moves = true; moves;) {
        const int from = mask.tightest();
        mask.toggle(from);
        const int to = mask.largest_void();
        moves = mask.energy(to) < mask.energy(from);
        mask.toggle(moves ? to : from);
    }
    return mask;
}

std::vector<int> made_ranks() {
    const Mask begun = relaxed_mask();
    std::vector<int> ranks(cell_count);
    for (Mask mask = begun; mask.size() > 0;) {
        const int cell = mask.tightest();
        mask.toggle(cell);
        ranks[std::size_t(cell)] = mask.size();
    }
    for (Mask mask = begun; mask.size() < cell_count;) {
        const int cell = mask.largest_void();
        ranks[std::size_t(cell)] = mask.size();
        mask.toggle(cell);
    }
    return ranks;
}

}  // namespace

const std::vector<int>& mask_ranks() {
    static const std::vector<int> ranks = made_ranks();
    return ranks;
}

}  // namespace zproof::oracle::filter_reference
