/// Which triangles come near which parts of the image: the judge's own search, independent of any renderer.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "compare/image_box.h"
#include "compare/tiles.h"
#include "scenes/scene.h"

namespace zproof {

/// What is asked about: a few boxes for each tile.
class AskedBoxes {
  public:
    explicit AskedBoxes(std::size_t tile_count) : tiles_(tile_count) {}

    /// A square that reaches beyond its tile by at most reach_px. Several threads may add to different tiles.
    void add(std::size_t tile, const Box& square, double reach_px);

    std::span<const Box> of(std::size_t tile) const {
        return tiles_[tile] ? std::span<const Box>(tiles_[tile]->boxes) : std::span<const Box>();
    }
    /// The largest of all.
    double reach_px() const;

  private:
    struct Asked {
        std::vector<Box> boxes;
        double reach_px = 0;
    };
    std::vector<std::unique_ptr<Asked>> tiles_;  ///< most are asked nothing about
};

/// Lists of triangles, one per tile, each ascending.
class TrianglesByTile {
  public:
    /// All triangles whose image (in front of half the near depth) may meet a box that its tile asks for. Too
    /// many is harmless, too few is not: images are widened by the rounding error of their own computation.
    /// Runs on all threads; one pass over the scene.
    TrianglesByTile(const Scene& scene, const View& view, const AskedBoxes& asked);

    std::span<const std::uint32_t> of(std::size_t tile) const {
        return std::span(triangles_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }

  private:
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace zproof
