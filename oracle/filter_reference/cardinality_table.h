/// The table of cardinality-constrained filtering: which texels stand for the mean over a square, and their
/// weights. From the normal equations, in rational numbers.
#pragma once

#include <vector>

namespace zproof::oracle::filter_reference {

/// A texel counted from the one of its level that holds the place; level 0 is the finer, 1 the coarser.
struct WeightedTexel {
    int level = 0, column = 0, row = 0;
    double weight = 0;
};

class CardinalityTable {
  public:
    using Entry = std::vector<WeightedTexel>;
    static constexpr int least_side = 9, most_side = 16, cells = 16;

    explicit CardinalityTable(int most);

    /// Sides are in eighths of a finer texel, cells sixteenths of a coarser one.
    const Entry& at(int side, int column_cell, int row_cell) const {
        return entries_[std::size_t(((side - least_side) * cells + row_cell) * cells + column_cell)];
    }

  private:
    std::vector<Entry> entries_;
};

}  // namespace zproof::oracle::filter_reference
