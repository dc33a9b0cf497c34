#include "rasterizer/tile_grid.h"

#include <algorithm>

namespace zproof::rasterizer {

PixelRect TileGrid::pixels(std::size_t tile, Resolution size) const {
    const int x0 = int(tile % std::size_t(columns)) * tile_size;
    const int y0 = int(tile / std::size_t(columns)) * tile_size;
    return {x0, y0, std::min(x0 + tile_size, size.width), std::min(y0 + tile_size, size.height)};
}

}  // namespace zproof::rasterizer
