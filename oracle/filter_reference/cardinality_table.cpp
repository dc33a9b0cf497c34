#include "oracle/filter_reference/cardinality_table.h"

#include <optional>

#include "math/rational.h"

namespace zproof::oracle::filter_reference {

namespace {

/// Finer texels -2 to 3 along either axis, from the first one on the coarser texel that holds the place.
constexpr int window_begin = -2, window_size = 6;
using Vector = std::vector<Rational>;

/// A texel that may be chosen, and what it has of each finer texel.
struct Candidate {
    int level = 0;  ///< 0 the finer, 1 the coarser
    int column = 0, row = 0;
    Vector share = Vector(window_size * window_size);
};

Candidate candidate(int level, int column, int row) {
    Candidate made{level, column, row};
    const int texels = 1 << level;
    for (int down = 0; down < texels; ++down)
        for (int right = 0; right < texels; ++right)
            made.share[std::size_t((row * texels + down - window_begin) * window_size + column * texels +
                                   right - window_begin)] = Rational{1, texels * texels};
    return made;
}

/// In the order in which equal ones are taken.
std::vector<Candidate> candidates() {
    std::vector<Candidate> all;
    for (const int level : {1, 0}) {
        const int texels = 1 << level;
        for (int row = window_begin / texels; row < (window_begin + window_size) / texels; ++row)
            for (int column = window_begin / texels; column < (window_begin + window_size) / texels; ++column)
                all.push_back(candidate(level, column, row));
    }
    return all;
}

Rational dot(const Vector& a, const Vector& b) {
    Rational sum{0};
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != 0 && b[i] != 0) sum += a[i] * b[i];
    return sum;
}

/// The share of texel i of a line that begins at `from` and has this length.
Rational covered(const Rational& from, const Rational& length, int i) {
    const Rational low = std::max(from, Rational{i}),
                   high = std::min(Rational{from + length}, Rational{i + 1});
    return high > low ? Rational{(high - low) / length} : Rational{0};
}

/// The mean over the square, as weights of the finer texels.
Vector target(int side_eighths, int column_cell, int row_cell) {
    const Rational side{side_eighths, 8};
    const auto begin = [&](int cell) { return Rational{Rational{2 * cell + 1, 16} - side / 2}; };
    Vector weights;
    for (int row = window_begin; row < window_begin + window_size; ++row)
        for (int column = window_begin; column < window_begin + window_size; ++column)
            weights.push_back(covered(begin(column_cell), side, column) *
                              covered(begin(row_cell), side, row));
    return weights;
}

/// G w = b, the normal equations of all candidates, from which those chosen are eliminated.
class NormalEquations {
  public:
    explicit NormalEquations(const std::vector<Candidate>& all) {
        for (const Candidate& a : all) {
            left_.emplace_back();
            for (const Candidate& b : all) left_.back().push_back(dot(a.share, b.share));
        }
    }
    void approximate(const std::vector<Candidate>& all, const Vector& wanted) {
        for (const Candidate& a : all) right_.push_back(dot(a.share, wanted));
    }
    /// The first one that takes the most off the sum of squares, b^2 / G; none where nothing does.
    std::optional<std::size_t> best() const {
        std::optional<std::size_t> found;
        Rational most{0};
        for (std::size_t i = 0; i < right_.size(); ++i) {
            if (right_[i] == 0) continue;
            const Rational less = right_[i] * right_[i] / left_[i][i];
            if (less > most) most = less, found = i;
        }
        return found;
    }
    void eliminate(std::size_t k) {
        const Vector pivot = left_[k];
        const Rational value = right_[k];
        for (std::size_t i = 0; i < right_.size(); ++i) {
            if (left_[i][k] == 0) continue;
            const Rational factor = left_[i][k] / pivot[k];
            for (std::size_t j = 0; j < right_.size(); ++j)
                if (pivot[j] != 0) left_[i][j] -= factor * pivot[j];
            right_[i] -= factor * value;
        }
    }

  private:
    std::vector<Vector> left_;
    Vector right_;
};

/// Gauss, of equations (left, right) whose pivots are not 0.
Vector solved(std::vector<Vector> rows) {
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = n + 1; j-- > k;) rows[k][j] /= rows[k][k];
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k || rows[i][k] == 0) continue;
            for (std::size_t j = n + 1; j-- > k;) rows[i][j] -= rows[i][k] * rows[k][j];
        }
    }
    Vector unknowns;
    for (const Vector& row : rows) unknowns.push_back(row.back());
    return unknowns;
}

/// Least squares under the condition that the weights sum to 1, by Lagrange's multiplier.
Vector weights_of_sum_one(const std::vector<Candidate>& chosen, const Vector& wanted) {
    std::vector<Vector> rows;
    for (const Candidate& a : chosen) {
        rows.emplace_back();
        for (const Candidate& b : chosen) rows.back().push_back(dot(a.share, b.share));
        rows.back().push_back(1);
        rows.back().push_back(dot(a.share, wanted));
    }
    rows.emplace_back(chosen.size(), Rational{1});
    rows.back().push_back(0);
    rows.back().push_back(1);
    return solved(std::move(rows));
}

/// `equations` are those of all, still without a right side.
CardinalityTable::Entry entry(const std::vector<Candidate>& all, NormalEquations equations,
                              const Vector& wanted, int most) {
    equations.approximate(all, wanted);
    std::vector<Candidate> chosen;
    while (int(chosen.size()) < most) {
        const std::optional<std::size_t> best = equations.best();
        if (!best) break;
        equations.eliminate(*best);
        chosen.push_back(all[*best]);
    }
    const Vector weights = weights_of_sum_one(chosen, wanted);
    CardinalityTable::Entry entry;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        entry.push_back({chosen[i].level, chosen[i].column, chosen[i].row, weights[i].convert_to<double>()});
    return entry;
}

}  // namespace

CardinalityTable::CardinalityTable(int most) {
    const std::vector<Candidate> all = candidates();
    const NormalEquations equations{all};
    for (int side = least_side; side <= most_side; ++side)
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column) {
                entries_.push_back(entry(all, equations, target(side, column, row), most));
                for (WeightedTexel& texel : entries_.back())
                    if (texel.level == 0) texel.column -= 2 * column / cells, texel.row -= 2 * row / cells;
            }
}

}  // namespace zproof::oracle::filter_reference
