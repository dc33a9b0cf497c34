/// The image in tiles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "frame/plane.h"
#include "rasterizer/tile_pixels.h"

namespace zproof::rasterizer {

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    std::uint64_t count() const { return std::uint64_t(x1 - x0) * std::uint64_t(y1 - y0); }
};

struct TileGrid {
    int columns = 0, rows = 0;

    TileGrid() = default;
    explicit TileGrid(Resolution size)
        : columns((size.width + tile_size - 1) / tile_size),
          rows((size.height + tile_size - 1) / tile_size) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    std::uint32_t tile_at(int column, int row) const { return std::uint32_t(row * columns + column); }
    /// The pixels of a tile, cut to the image.
    PixelRect pixels(std::size_t tile, Resolution size) const;
};

}  // namespace zproof::rasterizer
