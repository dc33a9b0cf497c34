#include "filters/reads/tiles.h"

#include <algorithm>

namespace zproof::texture::reads {

namespace {

std::size_t tiles_along(int size) { return std::size_t((size + tile_side - 1) / tile_side); }

std::size_t tiles_of(const LinearImage& image) {
    return tiles_along(image.width) * tiles_along(image.height);
}

void copy_row(const LinearImage& image, int row, Tile* tile) {
    for (int column = 0; column < image.width; column += tile_side, ++tile)
        std::copy_n(&image.at(column, row).x, 4 * std::min(tile_side, image.width - column),
                    tile->texels + std::ptrdiff_t{row % tile_side} * tile_side * 4);
}

Level level_of(const LinearImage& image, const LinearImage& largest, std::size_t first_tile) {
    constexpr std::size_t floats = sizeof(Tile) / sizeof(float);
    return {.first = double(floats * first_tile),
            .row_of_tiles = double(floats * tiles_along(image.width)),
            .width = double(image.width),
            .height = double(image.height),
            .per_width = 1.0 / image.width,
            .per_height = 1.0 / image.height,
            .scale_x = double(image.width) / largest.width,
            .scale_y = double(image.height) / largest.height};
}

}  // namespace

TiledImages::TiledImages(std::span<const LinearImage> images) {
    std::size_t tiles = 1;
    for (const LinearImage& image : images) {
        levels_.push_back(level_of(image, images[0], tiles));
        tiles += tiles_of(image);
    }
    tiles_.resize(tiles);
    tiles_[0] = {};
    tiles = 1;
    for (const LinearImage& image : images) {
        add(image, tiles);
        tiles += tiles_of(image);
    }
}

void TiledImages::add(const LinearImage& image, std::size_t first_tile) {
    for (int row = 0; row < image.height; ++row)
        copy_row(image, row, &tiles_[first_tile + std::size_t(row / tile_side) * tiles_along(image.width)]);
}

Chain TiledImages::chain(const Addressing& wrap) const {
    return {tiles_[0].texels, levels_.data(), wrap.u, wrap.v};
}

}  // namespace zproof::texture::reads
