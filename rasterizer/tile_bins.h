/// Sorting triangles into tiles, so that each tile can be drawn by one thread and sees its triangles in scene
/// order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rasterizer/triangle_setup.h"

namespace zproof::rasterizer {

struct TileGrid {
    int columns = 0, rows = 0;

    TileGrid() = default;
    explicit TileGrid(Resolution size)
        : columns((size.width + tile_size - 1) / tile_size),
          rows((size.height + tile_size - 1) / tile_size) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    /// The pixels of a tile, cut to the image.
    PixelRect pixels(std::size_t tile, Resolution size) const;
};

/// A run of the scene's triangles, sorted into tiles.
class BinnedRun {
  public:
    /// The triangles [begin, end) of the scene. Memory is kept from the time before.
    void fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
              std::size_t begin, std::size_t end);

    /// Valid while what the run was filled from is.
    TriangleRun triangles() const { return run_; }
    /// Of the triangles that may cover samples of a tile, in scene order.
    std::span<const std::uint32_t> places_in(std::size_t tile) const {
        return std::span(places_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }

  private:
    struct Entry {
        std::uint32_t tile, place;
    };
    void add(const Corners& corners, std::uint32_t place, const ViewSetup& setup);
    void add_to_tiles(const Placed& triangle, std::uint32_t place, const ViewSetup& setup);
    void add_to_tile(std::size_t tile, std::uint32_t place);
    void add_pieces(std::size_t first, const ViewSetup& setup);
    void sort();

    TriangleRun run_;
    TileGrid tiles_;
    std::vector<SnappedPiece> pieces_;
    std::vector<Entry> entries_;  ///< in scene order
    std::vector<std::uint32_t> places_, first_, next_;
};

/// The triangles of a view by tile.
class TileBins {
  public:
    /// Sorts every triangle of the scene, in fixed runs of triangles, on the threads of the surrounding
    /// tbb::task_arena: the bins do not depend on the number of threads.
    void fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup);

    /// The same for some triangles, a run for each range, drawn in the order of the ranges.
    void fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
              std::span<const Range> ranges);

    std::span<const BinnedRun> runs() const { return std::span(runs_).first(used_); }
    const TileGrid& tiles() const { return tiles_; }
    bool is_empty(std::size_t tile) const;

  private:
    TileGrid tiles_;
    std::vector<BinnedRun> runs_;  ///< those in use first
    std::size_t used_ = 0;
};

}  // namespace zproof::rasterizer
