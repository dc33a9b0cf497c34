/// Which triangles come near which parts of the image: the judge's own search, independent of any renderer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/image_box.h"
#include "scenes/scene.h"

namespace zproof {

/// The image cut into squares.
struct Tiles {
    static constexpr int side_px = 16;

    int columns = 0, rows = 0;

    explicit Tiles(const View& view)
        : columns((view.width + side_px - 1) / side_px), rows((view.height + side_px - 1) / side_px) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
    std::size_t of(int x, int y) const { return index(x / side_px, y / side_px); }
};

/// What is asked about: a few boxes for each tile.
class AskedBoxes {
  public:
    explicit AskedBoxes(std::size_t tile_count) : boxes_(tile_count), reach_px_(tile_count) {}

    /// A square that reaches beyond its tile by at most reach_px. Several threads may add to different tiles.
    void add(std::size_t tile, const Box& square, double reach_px);

    std::span<const Box> of(std::size_t tile) const { return boxes_[tile]; }
    /// The largest of all.
    double reach_px() const;

  private:
    std::vector<std::vector<Box>> boxes_;
    std::vector<double> reach_px_;
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
