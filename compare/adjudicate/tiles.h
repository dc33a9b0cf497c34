/// An image cut into squares.
#pragma once

#include <cstddef>

#include "scenes/view.h"

namespace zproof {

struct Tiles {
    static constexpr int side_px = 16;

    int columns, rows;

    explicit Tiles(const View& view)
        : columns((view.width + side_px - 1) / side_px), rows((view.height + side_px - 1) / side_px) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
    std::size_t of(int x, int y) const { return index(x / side_px, y / side_px); }
};

}  // namespace zproof
