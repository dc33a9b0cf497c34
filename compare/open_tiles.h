/// The pixels that the first pass leaves open, by tile and row.
#pragma once

#include <vector>

#include "compare/pixel_place.h"
#include "compare/tile_row.h"
#include "compare/tile_search.h"

namespace zproof {

static_assert(Tiles::side_px == tile_columns);

class OpenTiles {
  public:
    /// The pixels of one row of a tile: bit i of `pixels` is column i.
    struct Row {
        ColumnMask pixels = 0;
        ColumnMask lawful = 0;    ///< of those: both depths are so for certain
        std::uint32_t first = 0;  ///< place of its first pixel among all that are open; the others follow it
    };

    explicit OpenTiles(const View& view)
        : tiles_(view),
          height_(view.height),
          row_(tiles_.count() * Tiles::side_px),
          count_(tiles_.count()) {}

    /// Opens pixels of a row of a tile; `lawful` as Row has it. Several threads may open pixels of different rows
    /// of tiles. Places are known after number().
    void open(int column, int y, ColumnMask pixels, ColumnMask lawful);
    /// Numbers all open pixels in raster order; how many they are.
    std::size_t number();

    const Tiles& tiles() const { return tiles_; }
    const Row& row(int column, int y) const { return row_[index(column, y)]; }
    /// Are both depths of an open pixel lawful for certain?
    bool is_lawful(const PixelPlace& pixel) const {
        const int column = pixel.x / Tiles::side_px;
        return (row(column, pixel.y).lawful >> (pixel.x - column * Tiles::side_px) & 1) != 0;
    }
    /// Open pixels of a tile.
    std::uint32_t count(int column, int tile_row) const { return count_[tiles_.index(column, tile_row)]; }
    /// All open pixels in raster order.
    std::vector<PixelPlace> places() const;

  private:
    std::size_t index(int column, int y) const {
        return std::size_t(y) * std::size_t(tiles_.columns) + std::size_t(column);
    }

    Tiles tiles_;
    int height_;
    std::vector<Row> row_;
    std::vector<std::uint32_t> count_;  ///< by tile
};

}  // namespace zproof
