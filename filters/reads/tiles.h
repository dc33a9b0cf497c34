/// How the kernels want images: in tiles, so that texels which are near each other stand in the same page of
/// memory however the image is walked across.
#pragma once

#include <span>
#include <vector>

#include "filters/reads/kernel.h"
#include "math/bulk.h"
#include "texture/linear_image.h"

namespace zproof::texture::reads {

constexpr int tile_side = 16;  ///< texels; a power of two

/// Rows of RGBA texels: 4 KiB.
struct Tile {
    float texels[tile_side * tile_side * 4];
};

/// Images one after the other, each in rows of tiles. Immutable.
class TiledImages {
  public:
    /// The scale of each is its size over that of the first.
    explicit TiledImages(std::span<const LinearImage> images);

    /// Refers to what is in here.
    Chain chain(const Addressing& wrap) const;

  private:
    void add(const LinearImage& image, std::size_t first_tile);

    Bulk<Tile> tiles_;  ///< the first is all 0; texels beyond an image's right and lower edge nobody reads
    std::vector<Level> levels_;
};

}  // namespace zproof::texture::reads
