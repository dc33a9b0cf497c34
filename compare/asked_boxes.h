/// What of an image triangles are searched for.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "compare/float_box.h"
#include "compare/tiles.h"

namespace zproof {

/// A few boxes for each tile.
class AskedBoxes {
  public:
    explicit AskedBoxes(std::size_t tile_count) : tiles_(tile_count) {}

    /// A square that reaches beyond its tile by at most reach_px. Several threads may add to different tiles.
    void add(std::size_t tile, const Box& square, double reach_px);

    std::span<const Box> of(std::size_t tile) const {
        return tiles_[tile] ? std::span<const Box>(tiles_[tile]->boxes) : std::span<const Box>();
    }
    /// The largest of all.
    double reach_px() const;
    /// Boxes of all tiles.
    std::size_t count() const;

  private:
    struct Asked {
        std::vector<Box> boxes;
        double reach_px = 0;
    };
    std::vector<std::unique_ptr<Asked>> tiles_;  ///< most are asked nothing about
};

/// The tiles that anything is asked about, row by row.
class AskedTiles {
  public:
    struct Tile {
        std::uint32_t index;
        FloatBox all;  ///< around its boxes
        std::span<const FloatBox> boxes;
    };

    AskedTiles(const Tiles& tiles, const AskedBoxes& asked);
    AskedTiles(const AskedTiles&) = delete;  // a copy's tiles would look into this one's boxes
    AskedTiles& operator=(const AskedTiles&) = delete;

    std::span<const Tile> all() const { return tiles_; }
    /// Of a row, from one column to another, both included.
    std::span<const Tile> of(int row, int left, int right) const {
        return std::span(tiles_).subspan(first_at(left, row), first_at(right + 1, row) - first_at(left, row));
    }

  private:
    std::size_t first_at(int column, int row) const {
        return first_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }

    int columns_;
    std::vector<FloatBox> boxes_;
    std::vector<Tile> tiles_;  ///< in raster order
    /// By tile of the image, and for each row's end: the first of tiles_ from there on.
    std::vector<std::uint32_t> first_;
};

}  // namespace zproof
