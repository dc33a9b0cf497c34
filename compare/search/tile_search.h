/// Which triangles come near which parts of the image: the judge's own search, independent of any renderer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/search/asked_tiles.h"
#include "math/bulk.h"
#include "scenes/scene.h"

namespace zproof {

/// Lists of triangles, one per tile, each ascending.
class TrianglesByTile {
  public:
    /// All triangles whose image (in front of half the near depth) may meet a box that its tile asks for. Too
    /// many is harmless, too few is not: images are widened by the rounding error of their own computation.
    /// Runs on all threads; one pass over the scene.
    TrianglesByTile(const Scene& scene, const View& view, const AskedTiles& asked);

    std::span<const std::uint32_t> of(std::size_t tile) const {
        return std::span(triangles_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }

  private:
    std::vector<std::size_t> first_;
    Bulk<std::uint32_t> triangles_;
};

}  // namespace zproof
