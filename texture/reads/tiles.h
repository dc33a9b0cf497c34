/// How the kernels want an image: in tiles, so that texels which are near each other stand in the same page
/// of memory however the image is walked across.
#pragma once

#include <vector>

#include "texture/linear_image.h"

namespace zproof::texture::reads {

constexpr int tile_side = 16;  ///< texels; a power of two

/// Rows of RGBA texels: 4 KiB, a page.
struct alignas(4096) Tile {
    float texels[tile_side * tile_side * 4];
};

/// Row by row; the texels beyond the image's right and lower edge are 0 and nobody reads them.
std::vector<Tile> tiles_of(const LinearImage& image);

}  // namespace zproof::texture::reads
