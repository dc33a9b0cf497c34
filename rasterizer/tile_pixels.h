/// What is drawn into: one tile. Plain data only: kernels see it (kernel.h).
#pragma once

#include <cstdint>
#include <limits>

namespace zproof::rasterizer {

inline constexpr int tile_size = 64;  ///< pixels; a tile's depths and ids are 32 KiB, a first-level cache

inline constexpr int blocks_in_row = tile_size / 4;

/// The inverse depth of a pixel that nothing was drawn into.
inline constexpr float nothing_seen = -std::numeric_limits<float>::infinity();

/// One tile's pixels in blocks of 4 x 4, a cache line each, row by row; and in cells of 4 x 4 blocks. A
/// block, or cell, none of whose pixels holds less than `farthest` is not drawn by what cannot pass.
struct TilePixels {
    static constexpr int cells = 16, blocks = tile_size * tile_size / 16;
    alignas(64) float inverse_depth[blocks * 16];
    alignas(64) std::uint32_t primitive[blocks * 16];  ///< ids; of a count, how many fragments
    alignas(64) float hiz[blocks], hiz_of_cell[cells];
};

/// The place of pixel (x, y) of the tile.
[[gnu::always_inline]] constexpr int place_in_tile(int x, int y) {
    const int block = y / 4 * blocks_in_row + x / 4;
    return block * 16 + y % 4 * 4 + x % 4;
}

/// The tile on the sub-pixel grid, and who owns samples on edges.
struct TileSamples {
    int x0 = 0, y0 = 0;  ///< the tile's first pixel
    int subpixel_bits = 8;
    std::int32_t sample_offset = 128;
    /// The least value of an edge function that is covered, by top and left edges and by the others.
    std::int32_t least_of_top_left = 0, least_of_others = 1;
    int columns = tile_size, rows = tile_size;  ///< of the tile that are the image's
};

}  // namespace zproof::rasterizer
