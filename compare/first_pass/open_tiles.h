/// The pixels that the first pass leaves open, by tile and row.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "compare/pixel_place.h"
#include "compare/tile_row.h"
#include "compare/tiles.h"

namespace zproof {

static_assert(Tiles::side_px == tile_columns);

class OpenTiles {
  public:
    /// The pixels of one row of a tile: bit i of `pixels` is column i.
    struct Row {
        ColumnMask pixels = 0;
        ColumnMask lawful = 0;    ///< of those: ids differ, and both depths are so for certain
        std::uint32_t first = 0;  ///< place of its first pixel among all that are open; the others follow it
    };

    explicit OpenTiles(const View& view)
        : tiles_(view), place_(tiles_.count()), bands_(std::size_t(tiles_.rows)) {}

    /// Opens pixels of a row of a tile; `lawful` as Row has it. Several threads may open pixels of different
    /// rows of tiles. Places are known after number().
    void open(int column, int y, ColumnMask pixels, ColumnMask lawful);
    /// Numbers all open pixels in raster order; how many they are.
    std::size_t number();

    const Tiles& tiles() const { return tiles_; }
    const Row& row(int column, int y) const {
        static constexpr Row nothing_open{};
        const OpenTile* const tile = tile_at(column, y / Tiles::side_px);
        return tile ? tile->rows[std::size_t(y % Tiles::side_px)] : nothing_open;
    }
    /// Of a tile with open pixels.
    std::span<const Row> rows_of(int column, int tile_row) const {
        const OpenTile* const tile = tile_at(column, tile_row);
        assert(tile);
        return tile->rows;
    }
    /// Do ids of an open pixel differ, and are both depths lawful for certain?
    bool is_lawful(const PixelPlace& pixel) const {
        const int column = pixel.x / Tiles::side_px;
        return (row(column, pixel.y).lawful >> (pixel.x - column * Tiles::side_px) & 1) != 0;
    }
    /// Tiles with open pixels.
    std::size_t tiles_open() const;
    /// Open pixels of a tile.
    std::uint32_t count(int column, int tile_row) const {
        const OpenTile* const tile = tile_at(column, tile_row);
        return tile ? tile->count : 0;
    }
    /// All open pixels in raster order.
    std::vector<PixelPlace> places() const;

  private:
    /// A tile with open pixels. Of most frames few are: the others take no memory.
    struct OpenTile {
        int column;
        std::uint32_t count = 0;
        std::array<Row, Tiles::side_px> rows{};
    };
    using Band = std::vector<OpenTile>;  ///< those of a row of tiles, as they were opened

    const OpenTile* tile_at(int column, int tile_row) const {
        const std::uint16_t place = place_[tiles_.index(column, tile_row)];
        return place != 0 ? &bands_[std::size_t(tile_row)][place - 1u] : nullptr;
    }

    /// The place of each band's first pixel among all that are open; at the end, how many there are.
    std::vector<std::uint32_t> first_of_bands() const;

    Tiles tiles_;
    std::vector<std::uint16_t> place_;  ///< by tile: in its band, counted from 1; 0 where nothing is open
    std::vector<Band> bands_;
};

}  // namespace zproof
