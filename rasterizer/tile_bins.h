/// Sorting triangles into tiles, so that each tile can be drawn by one thread and sees its triangles in scene
/// order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rasterizer/triangle_setup.h"

namespace zproof::rasterizer {

inline constexpr int tile_size =
    64;  ///< pixels; a tile's z-buffer and ids are 32 KiB, the usual first-level cache

struct TileGrid {
    int columns = 0, rows = 0;

    explicit TileGrid(Resolution size)
        : columns((size.width + tile_size - 1) / tile_size),
          rows((size.height + tile_size - 1) / tile_size) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    /// The pixels of a tile, cut to the image.
    PixelRect pixels(std::size_t tile, Resolution size) const;
};

/// The triangles of a view by tile.
class TileBins {
  public:
    /// Sets up every triangle of the scene in fixed runs of triangles, on the threads of the surrounding
    /// tbb::task_arena, then joins the runs in order: the bins do not depend on the number of threads.
    TileBins(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup);

    TileBins(const TileBins&) = delete;  // members_ points into triangles_
    TileBins& operator=(const TileBins&) = delete;

    /// The triangles that may cover samples of a tile, in scene order.
    std::span<const SnappedTriangle* const> in_tile(std::size_t tile) const {
        return std::span(members_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }
    const TileGrid& tiles() const { return tiles_; }

  private:
    struct Run;

    void join(const std::vector<Run>& runs);

    TileGrid tiles_;
    std::vector<std::vector<SnappedTriangle>> triangles_;  ///< by run
    std::vector<std::size_t> first_;  ///< of each tile, into members_; one more at the end
    std::vector<const SnappedTriangle*> members_;
};

}  // namespace zproof::rasterizer
