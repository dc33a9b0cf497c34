#include "texture/reads/tiles.h"

#include <algorithm>

namespace zproof::texture::reads {

std::vector<Tile> tiles_of(const LinearImage& image) {
    const int across = (image.width + tile_side - 1) / tile_side,
              down = (image.height + tile_side - 1) / tile_side;
    std::vector<Tile> tiles(std::size_t(across) * std::size_t(down));
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; column += tile_side) {
            Tile& tile =
                tiles[std::size_t(row / tile_side) * std::size_t(across) + std::size_t(column / tile_side)];
            const float* const from = &image.at(column, row).x;
            std::copy_n(from, 4 * std::min(tile_side, image.width - column),
                        tile.texels + row % tile_side * tile_side * 4);
        }
    return tiles;
}

}  // namespace zproof::texture::reads
