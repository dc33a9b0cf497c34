#include "texture/constrained_texels.h"

#include <algorithm>
#include <array>

namespace zproof::texture {

namespace {

constexpr int least_side = 9, most_side = 16, cells = 16;

/// The finer texels on a coarser texel and on both its neighbours along an axis: the square reaches no
/// farther.
constexpr int blocks = 3, window = 2 * blocks, window_begin = -2;

/// How much of each the square's side covers, in 32nds of a finer texel.
using AxisTarget = std::array<int, window>;

AxisTarget axis_target(int side_eighths, int cell) {
    const int centre = 4 * cell + 2, half = 2 * side_eighths;
    AxisTarget covered{};
    for (int i = 0; i < window; ++i) {
        const int texel = 32 * (window_begin + i);
        covered[std::size_t(i)] =
            std::max(0, std::min(centre + half, texel + 32) - std::max(centre - half, texel));
    }
    return covered;
}

/// The finer texels of a block that are not chosen themselves, and what the square covers of them.
struct Rest {
    int texels = 0, sum = 0, squares = 0;

    /// Twelve times what is left of the squares, without the coarser texel and with it.
    int left() const { return 12 * squares; }
    int left_by_mean() const { return texels == 0 ? 0 : 12 * squares - 12 / texels * sum * sum; }
    double mean() const { return double(sum) / texels; }
};

/// Some texels of both levels. With t of each finer texel, sum t <= 2^12 and t <= 2^10: twelve times the sum
/// of the squares is below 2^26.
class Choice {
  public:
    Choice(const AxisTarget& across, const AxisTarget& down) : across_{across}, down_{down} {}

    /// Adds the texel with which the least is left, the first of several. False where none lessens it.
    bool add_best();
    std::vector<ConstrainedTexel> weighted(WeightTotal total) const;

  private:
    static constexpr std::size_t coarser = blocks * blocks, all = coarser + window * window;

    static std::size_t finer(std::size_t column, std::size_t row) { return coarser + row * window + column; }
    int target(std::size_t column, std::size_t row) const { return across_[column] * down_[row]; }
    Rest rest_of(std::size_t block) const;
    int left() const;
    double spread() const;

    AxisTarget across_, down_;
    std::array<bool, all> is_chosen_{};  ///< coarser texels first, either level row by row
};

Rest Choice::rest_of(std::size_t block) const {
    Rest rest;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t column = 2 * (block % blocks) + i % 2, row = 2 * (block / blocks) + i / 2;
        if (is_chosen_[finer(column, row)]) continue;
        const int t = target(column, row);
        rest.texels += 1, rest.sum += t, rest.squares += t * t;
    }
    return rest;
}

int Choice::left() const {
    int sum = 0;
    for (std::size_t block = 0; block < coarser; ++block) {
        const Rest rest = rest_of(block);
        sum += is_chosen_[block] ? rest.left_by_mean() : rest.left();
    }
    return sum;
}

bool Choice::add_best() {
    std::size_t best = all;
    int least = left();
    for (std::size_t texel = 0; texel < all; ++texel) {
        if (is_chosen_[texel]) continue;
        is_chosen_[texel] = true;
        if (const int now = left(); now < least) least = now, best = texel;
        is_chosen_[texel] = false;
    }
    if (best == all) return false;
    return is_chosen_[best] = true;
}

/// What the chosen texels do not cover, for each finer texel that they do cover.
double Choice::spread() const {
    int missing = 0, covered = 0;
    for (std::size_t block = 0; block < coarser; ++block) {
        const Rest rest = rest_of(block);
        missing += is_chosen_[block] ? 0 : rest.sum;
        covered += is_chosen_[block] ? 4 : 4 - rest.texels;
    }
    return double(missing) / covered;
}

/// Left to themselves, a finer texel makes its own t and a coarser one the mean of the rest of its block. To
/// hold the sum, least squares add the same to all that is covered. A finer texel on a coarser one makes the
/// difference.
std::vector<ConstrainedTexel> Choice::weighted(WeightTotal total) const {
    using Level = ConstrainedTexel::Level;
    int sum = 0;
    for (const int u : across_)
        for (const int v : down_) sum += u * v;
    const double more = total == WeightTotal::one ? spread() : 0;
    std::vector<ConstrainedTexel> chosen;
    for (std::size_t block = 0; block < coarser; ++block)
        if (is_chosen_[block])
            chosen.push_back({Level::coarser, int(block % blocks) - 1, int(block / blocks) - 1,
                              4 * (rest_of(block).mean() + more) / sum});
    for (std::size_t row = 0; row < window; ++row)
        for (std::size_t column = 0; column < window; ++column) {
            if (!is_chosen_[finer(column, row)]) continue;
            const std::size_t block = row / 2 * blocks + column / 2;
            const double own = is_chosen_[block] ? -rest_of(block).mean() : more;
            chosen.push_back({Level::finer, int(column) + window_begin, int(row) + window_begin,
                              (target(column, row) + own) / sum});
        }
    return chosen;
}

/// Finer texels counted from the one that holds the cell.
std::vector<ConstrainedTexel> entry(int side_eighths, int column_cell, int row_cell, int most,
                                    WeightTotal total) {
    Choice choice{axis_target(side_eighths, column_cell), axis_target(side_eighths, row_cell)};
    for (int texels = 0; texels < most && choice.add_best();) ++texels;
    std::vector<ConstrainedTexel> chosen = choice.weighted(total);
    for (ConstrainedTexel& texel : chosen)
        if (texel.level == ConstrainedTexel::Level::finer)
            texel.column -= column_cell / 8, texel.row -= row_cell / 8;
    return chosen;
}

}  // namespace

ConstrainedTexels::ConstrainedTexels(int most, WeightTotal total) {
    for (int side = least_side; side <= most_side; ++side)
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column)
                entries_.push_back(entry(side, column, row, most, total));
}

std::span<const ConstrainedTexel> ConstrainedTexels::at(int side_eighths, int column_cell,
                                                        int row_cell) const {
    return entries_[std::size_t(((side_eighths - least_side) * cells + row_cell) * cells + column_cell)];
}

}  // namespace zproof::texture
