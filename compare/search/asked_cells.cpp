#include "compare/search/asked_cells.h"

#include <algorithm>

namespace zproof {

AskedCells::AskedCells(const View& view, const AskedTiles& asked)
    : columns_((view.width + side_px - 1) / side_px),
      rows_((view.height + side_px - 1) / side_px),
      last_{columns_ - 1, rows_ - 1, columns_ - 1, rows_ - 1},
      sums_(std::size_t(columns_ + 1) * std::size_t(rows_ + 1)) {
    std::vector<bool> is_marked(std::size_t(rows_), false);
    for (const AskedTiles::Tile& tile : asked.all()) {
        const bool are_large = !tile.boxes[0].fits(Tiles::side_px);  // and mostly in each other
        for (const FloatBox& box : are_large ? std::span(&tile.all, 1) : tile.boxes)
            mark(cells_of(box), is_marked);
    }
    for (int row = 0; row < rows_; ++row) {
        if (is_marked[std::size_t(row)])
            sum_up(row);
        else
            std::copy_n(&at(0, row), columns_ + 1, &at(0, row + 1));
    }
}

void AskedCells::mark(const FloatBox::Places& cells, std::vector<bool>& is_marked) {
    for (int row = cells[1]; row <= cells[3]; ++row) {
        is_marked[std::size_t(row)] = true;
        for (int column = cells[0]; column <= cells[2]; ++column) at(column + 1, row + 1) = 1;
    }
}

void AskedCells::sum_up(int row) {
    Sum of_row = 0;
    for (int column = 1; column <= columns_; ++column) {
        of_row = Sum(of_row + at(column, row + 1));
        at(column, row + 1) = Sum(at(column, row) + of_row);
    }
}

}  // namespace zproof
