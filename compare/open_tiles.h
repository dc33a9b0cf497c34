/// Open pixels by tile and row.
#pragma once

#include <span>
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
        std::uint32_t first = 0;  ///< place of its first pixel among all that are open; the others follow it
    };
    struct Tile {
        std::array<Row, Tiles::side_px> rows;
        std::uint32_t count = 0;
    };

    /// `open` in raster order; on all threads.
    OpenTiles(const View& view, std::span<const PixelPlace> open);

    const Tiles& tiles() const { return tiles_; }
    const Tile& at(int column, int row) const { return tile_[tiles_.index(column, row)]; }

  private:
    Tiles tiles_;
    std::vector<Tile> tile_;
};

}  // namespace zproof
