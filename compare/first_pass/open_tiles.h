/// The pixels that the first pass leaves open, by tile.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "compare/pixel_place.h"
#include "compare/tile_mask.h"
#include "compare/tiles.h"
#include "math/bulk.h"

namespace zproof {

class OpenTiles {
  public:
    /// A tile with open pixels.
    struct Tile {
        int column;
        std::uint32_t count;  ///< of pixels
        TileMask pixels;      ///< all that were opened
        TileMask differ;      ///< of those: ids do
        TileMask lawful;      ///< of those: both depths are so for certain
        TileMask left;        ///< of those: nobody has decided them yet
        /// By row: the number of its first open pixel; the others follow it. Known after number().
        std::array<std::uint32_t, TileMask::rows> first;
    };

    explicit OpenTiles(const View& view)
        : tiles_(view), place_(tiles_.count()), bands_(std::size_t(tiles_.rows)) {}

    /// As Tile has it.
    struct Opened {
        TileMask pixels, differ, lawful;
    };
    /// Opens some pixels of a tile. Of a row of tiles from left to right, each once; several threads may open
    /// tiles of different rows.
    void open(int column, int tile_row, const Opened& opened);
    /// Numbers all open pixels in raster order.
    void number();

    const Tiles& tiles() const { return tiles_; }
    /// Of a row of tiles those with open pixels, from left to right.
    std::span<const Tile> of_row(int tile_row) const { return bands_[std::size_t(tile_row)]; }
    std::span<Tile> of_row(int tile_row) { return bands_[std::size_t(tile_row)]; }

    /// How many pixels were opened.
    std::size_t count() const;
    /// All that are left, tile by tile.
    Bulk<PixelPlace> left() const;

    /// Of an open pixel: as number() has it.
    std::uint32_t number_of(const PixelPlace& pixel) const;
    /// Do ids of an open pixel differ, and are both depths lawful for certain?
    bool is_lawful(const PixelPlace& pixel) const {
        const auto [column, y] = in_tile(pixel);
        return (tile_of(pixel).lawful.row(y) >> column & 1) != 0;
    }

  private:
    struct InTile {
        int column, y;
    };
    static InTile in_tile(const PixelPlace& pixel) {
        return {pixel.x % Tiles::side_px, pixel.y % Tiles::side_px};
    }
    const Tile& tile_of(const PixelPlace& pixel) const {
        const std::uint16_t place = place_[tiles_.of(pixel.x, pixel.y)];
        assert(place != 0);
        return bands_[std::size_t(pixel.y / Tiles::side_px)][place - 1u];
    }

    Tiles tiles_;
    std::vector<std::uint16_t> place_;      ///< by tile: in its band, counted from 1; 0 where nothing is open
    std::vector<std::vector<Tile>> bands_;  ///< by row of tiles: where nothing is open takes no memory
};

/// Of an open pixel, in a column and row of its tile: as OpenTiles::number() has it.
std::uint32_t number_in(const OpenTiles::Tile& tile, int column, int y);

}  // namespace zproof
