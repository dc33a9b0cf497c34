/// What of an image triangles are searched for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/search/float_box.h"
#include "compare/tiles.h"
#include "math/bulk.h"

namespace zproof {

/// The tiles that anything is asked about, row by row, each with a few boxes.
class AskedTiles {
  public:
    struct Tile {
        FloatBox all{};  ///< around its boxes
        std::span<FloatBox> boxes{};
        double reach_px = 0;  ///< so far its boxes may reach beyond the tile
        std::uint32_t index = 0, room = 0;
    };

    /// boxes_of_tile: at least as many as will be added to each; where that is none, nothing is asked.
    AskedTiles(const Tiles& tiles, std::span<const std::uint32_t> boxes_of_tile);
    AskedTiles(AskedTiles&&) = default;  // a copy's tiles would look into this one's boxes

    /// Adds a square that reaches beyond its tile by at most reach_px; every tile needs one. Several threads
    /// may add to different tiles.
    void add(std::size_t tile, const Box& square, double reach_px);

    std::span<const Tile> all() const { return tiles_; }
    /// Of a row, from one column to another, both included.
    std::span<const Tile> of(int row, int left, int right) const {
        return std::span(tiles_).subspan(first_at(left, row), first_at(right + 1, row) - first_at(left, row));
    }
    bool has(int column, int row) const { return !of(row, column, column).empty(); }
    /// The largest of all.
    double reach_px() const;

  private:
    std::size_t first_at(int column, int row) const {
        return first_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }

    int columns_;
    Bulk<FloatBox> boxes_;
    Bulk<Tile> tiles_;  ///< in raster order
    /// By tile of the image, and for each row's end: the first of tiles_ from there on.
    std::vector<std::uint32_t> first_;
};

}  // namespace zproof
