#include "filters/reference/cardinality_taps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace zproof::oracle::filter_reference {

namespace {

/// What the finest level's texels from -4 to 7 along either axis weigh.
constexpr int grid_side = 12, grid_first = -4;
using Weights = std::array<double, std::size_t{grid_side} * grid_side>;

double product(const Weights& a, const Weights& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// The share of a line's part [low, high] that lies in each texel.
std::array<double, grid_side> shares(double low, double high) {
    std::array<double, grid_side> line{};
    for (int i = 0; i < grid_side; ++i)
        line[std::size_t(i)] =
            std::max(0.0, std::min(high, grid_first + i + 1.0) - std::max(low, double(grid_first + i))) /
            (high - low);
    return line;
}

Weights rectangle(double left, double right, double top, double bottom) {
    const auto across = shares(left, right), down = shares(top, bottom);
    Weights grid;
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = down[i / grid_side] * across[i % grid_side];
    return grid;
}

struct Texel {
    int level, column, row;
    Weights mean;
};

/// All that touch the pixel's box with more than an edge.
std::vector<Texel> texels_under(double x, double y, double half) {
    std::vector<Texel> all;
    for (int level = 2; level >= 0; --level) {
        const int size = 1 << level;
        for (int row = -8; row < 12; ++row)
            for (int column = -8; column < 12; ++column) {
                const double left = column * size, top = row * size;
                if (left < x + half && left + size > x - half && top < y + half && top + size > y - half)
                    all.push_back({level, column, row, rectangle(left, left + size, top, top + size)});
            }
    }
    return all;
}

/// Gaussian elimination with row exchanges; the last column is the right side.
std::vector<double> solution(std::vector<std::vector<double>> rows) {
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
        std::swap(rows[k], rows[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double times = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j <= n; ++j) rows[i][j] -= times * rows[k][j];
        }
    }
    std::vector<double> x;
    for (std::size_t k = 0; k < n; ++k) x.push_back(rows[k][n] / rows[k][k]);
    return x;
}

using Set = std::vector<std::size_t>;

/// The problem of one entry.
class Entry {
  public:
    Entry(int u, int v, int lod)
        : x_{u / 8.0}, y_{v / 8.0}, side_{std::exp2(lod / 8.0)}, all_{texels_under(x_, y_, side_ / 2)} {
        const Weights target = rectangle(x_ - side_ / 2, x_ + side_ / 2, y_ - side_ / 2, y_ + side_ / 2);
        for (const Texel& a : all_) {
            with_target_.push_back(product(a.mean, target));
            products_.emplace_back();
            for (const Texel& b : all_) products_.back().push_back(product(a.mean, b.mean));
        }
    }

    std::vector<ChosenTexel> chosen(std::size_t most) const {
        Set set;
        for (auto next = better_than(set, most); next; next = better_than(set, most)) set = *next;
        const std::vector<double> weights = weights_of(set);
        std::vector<ChosenTexel> result;
        for (std::size_t i = 0; i < set.size(); ++i) {
            const Texel& t = all_[set[i]];
            result.push_back(
                {t.level, t.column - (int(x_) >> t.level), t.row - (int(y_) >> t.level), weights[i]});
        }
        return result;
    }

  private:
    /// A millionth of the target's square, 1 / side^2.
    double little() const { return 0x1p-20 / (side_ * side_); }

    /// Weights of sum 1: (products + little I) w + multiplier = with_target.
    std::vector<double> weights_of(const Set& set) const {
        std::vector<std::vector<double>> rows;
        for (const std::size_t i : set) {
            rows.emplace_back();
            for (const std::size_t j : set) rows.back().push_back(products_[i][j] + (i == j ? little() : 0));
            rows.back().push_back(1);
            rows.back().push_back(with_target_[i]);
        }
        rows.emplace_back(set.size(), 1.0);
        rows.back().push_back(0);
        rows.back().push_back(1);
        std::vector<double> all = solution(std::move(rows));
        all.pop_back();
        return all;
    }
    /// |sum w mean - target|^2 + little |w|^2, less the target's own square; of no texel at all, infinite.
    double error_of(const Set& set) const {
        if (set.empty()) return std::numeric_limits<double>::infinity();
        const std::vector<double> w = weights_of(set);
        double error = 0;
        for (std::size_t i = 0; i < set.size(); ++i) {
            error += little() * w[i] * w[i] - 2 * w[i] * with_target_[set[i]];
            for (std::size_t j = 0; j < set.size(); ++j) error += w[i] * w[j] * products_[set[i]][set[j]];
        }
        return error;
    }
    /// The first of the sets that come within a little of the least error.
    Set best(const std::vector<Set>& sets) const {
        std::vector<double> errors;
        errors.reserve(sets.size());
        for (const Set& set : sets) errors.push_back(error_of(set));
        const double least = *std::ranges::min_element(errors);
        for (std::size_t i = 0; i < sets.size(); ++i)
            if (errors[i] <= least + little()) return sets[i];
        throw std::logic_error("no set of texels");
    }
    bool is_better(const Set& a, const Set& b) const { return error_of(a) < error_of(b) - little(); }
    /// One more, if there is room and it helps; else one fewer, if it is not missed; else another for one, if
    /// that helps.
    std::optional<Set> better_than(const Set& set, std::size_t most) const {
        if (set.size() < most && set.size() < all_.size())
            if (const Set more = with_one_more(set); is_better(more, set)) return more;
        if (set.size() < 2) return {};
        std::vector<Set> fewer, exchanged;
        for (std::size_t i = 0; i < set.size(); ++i) {
            fewer.push_back(set);
            fewer.back().erase(fewer.back().begin() + std::ptrdiff_t(i));
            exchanged.push_back(with_one_more(fewer.back()));
        }
        if (const Set least_missed = best(fewer); !is_better(set, least_missed)) return least_missed;
        if (const Set other = best(exchanged); is_better(other, set)) return other;
        return {};
    }
    Set with_one_more(const Set& set) const {
        std::vector<Set> sets;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (std::ranges::find(set, i) != set.end()) continue;
            sets.push_back(set);
            sets.back().push_back(i);
        }
        return best(sets);
    }

    double x_, y_, side_;
    std::vector<Texel> all_;
    std::vector<double> with_target_;
    std::vector<std::vector<double>> products_;
};

}  // namespace

const std::vector<ChosenTexel>& ChosenTexels::at(int u, int v, int lod) {
    const auto entry = std::size_t(lod) * places * places + std::size_t(v) * places + std::size_t(u);
    std::call_once(once_[entry], [&] { found_[entry] = Entry{u, v, lod}.chosen(std::size_t(most_)); });
    return found_[entry];
}

ChosenTexels& chosen_texels(int most) {
    static ChosenTexels four{4}, eight{8};
    return most == 4 ? four : eight;
}

}  // namespace zproof::oracle::filter_reference
