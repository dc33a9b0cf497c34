/// Where of an image anything is asked about, cell by cell.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "compare/search/asked_tiles.h"
#include "scenes/view.h"

namespace zproof {

/// Of the image cut into cells, how many above and left of a place hold anything that is asked about, modulo
/// 2^16: any in a rectangle by four look-ups, where it has fewer cells than that. What lies beyond the image
/// counts to the cells at its border.
class AskedCells {
  public:
    AskedCells(const View& view, const AskedTiles& asked);

    /// A rectangle of 2^16 cells and more is taken to hold some.
    bool any(const FloatBox& in) const {
        const FloatBox::Places cells = cells_of(in);
        const int left = cells[0], top = cells[1], right = cells[2], bottom = cells[3];
        const int count = (right - left + 1) * (bottom - top + 1);
        const int sum = at(right + 1, bottom + 1) - at(left, bottom + 1) - at(right + 1, top) + at(left, top);
        return Sum(sum) != 0 || count > int{std::numeric_limits<Sum>::max()};
    }

  private:
    static constexpr int side_px = 4;
    using Sum = std::uint16_t;

    FloatBox::Places cells_of(const FloatBox& box) const { return box.cells(side_px, last_); }
    void mark(const FloatBox::Places& cells, std::vector<bool>& is_marked);
    void sum_up(int row);
    std::size_t place(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column);
    }
    Sum& at(int column, int row) { return sums_[place(column, row)]; }
    Sum at(int column, int row) const { return sums_[place(column, row)]; }

    int columns_, rows_;
    FloatBox::Places last_;  ///< cells, as cells_of() has them
    std::vector<Sum> sums_;  ///< not kept for the next verdict: 4 MiB of an image at 8K
};

}  // namespace zproof
