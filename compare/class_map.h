/// What was said about every pixel of a view.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

#include "compare/pixel_class.h"
#include "compare/tiles.h"
#include "frame/plane.h"
#include "math/bulk.h"

namespace zproof {

/// A class for each pixel. A tile in which all agree takes no memory beside its place.
class ClassMap {
  public:
    ClassMap() = default;
    /// All pixels agree. Valid: whatever a Plane may be.
    explicit ClassMap(Resolution size)
        : size_(size), tiles_(size), place_(tiles_.count()), bands_(std::size_t(tiles_.rows)) {}

    Resolution size() const { return size_; }
    PixelClass at(int x, int y) const {
        assert(x >= 0 && x < size_.width && y >= 0 && y < size_.height);
        return place_[tiles_.of(x, y)] != 0 ? tile_of(x, y)[in_tile(x, y)] : PixelClass::agree;
    }
    /// The same, pixel by pixel.
    Plane<PixelClass> plane() const;

    /// Makes open() of so many tiles of a row take no memory beyond theirs.
    void reserve(int row, std::size_t tiles) { bands_[std::size_t(row)].reserve(tiles); }
    /// Makes room in a tile for other classes. Several threads may open tiles of different rows; references
    /// to pixels of the row end.
    void open(int column, int row);
    /// Of a pixel in an open tile; several threads may write to different pixels.
    PixelClass& in_open(int x, int y) {
        assert(x >= 0 && x < size_.width && y >= 0 && y < size_.height && place_[tiles_.of(x, y)] != 0);
        return tile_at(x / Tiles::side_px, y / Tiles::side_px)[in_tile(x, y)];
    }

    /// Of a tile that is open, row by row.
    using Tile = std::array<PixelClass, std::size_t(Tiles::side_px* Tiles::side_px)>;
    Tile& tile_at(int column, int row) {
        assert(place_[tiles_.index(column, row)] != 0);
        return bands_[std::size_t(row)][place_[tiles_.index(column, row)] - 1u];
    }

    /// Opens the pixel's tile where it is not. For one thread.
    void set(int x, int y, PixelClass c) {
        open(x / Tiles::side_px, y / Tiles::side_px);
        in_open(x, y) = c;
    }

  private:
    static_assert(PixelClass{} == PixelClass::agree);

    const Tile& tile_of(int x, int y) const {
        return bands_[std::size_t(y / Tiles::side_px)][place_[tiles_.of(x, y)] - 1u];
    }
    static std::size_t in_tile(int x, int y) {
        return std::size_t(y % Tiles::side_px) * Tiles::side_px + std::size_t(x % Tiles::side_px);
    }

    Resolution size_;
    Tiles tiles_;
    std::vector<std::uint16_t> place_;  ///< by tile: in its band, counted from 1; 0 where all agree
    std::vector<Bulk<Tile>> bands_;     ///< by row of tiles: the open ones
};

}  // namespace zproof
