/// Sorting triangles into tiles, so that each tile can be drawn by one thread and sees its triangles in the
/// order of drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/bulk.h"
#include "math/processor.h"
#include "rasterizer/binned_run.h"
#include "rasterizer/kernel.h"
#include "rasterizer/projected_vertices.h"
#include "rasterizer/tile_grid.h"

namespace zproof::rasterizer {

/// The triangles of a view by tile.
class TileBins {
  public:
    explicit TileBins(const Kernel& kernel = widest_of(kernels)) : kernel_(kernel) {}

    /// Sorts every triangle of the scene, in fixed runs of triangles, on the threads of the surrounding
    /// tbb::task_arena: the bins do not depend on the number of threads. Memory is kept from the time before.
    /// Throws std::length_error for 2^31 triangles and pieces of triangles, or more.
    void fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup);

    /// Fills the bins with some triangles, drawn in the order of the ranges.
    void fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
              std::span<const IndexRange> ranges);

    /// The triangles are valid while what the bins were filled from is.
    const Triangles& triangles() const { return triangles_; }
    /// The triangles that may cover samples of a tile, in the order of drawing.
    std::span<const std::uint32_t> entries_in(std::size_t tile) const {
        return std::span(entries_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }
    std::span<const SnappedPiece> pieces() const { return pieces_; }
    const TileGrid& tiles() const { return tiles_; }
    BinTally tally() const;

  private:
    void lend_to_runs(std::span<const IndexRange> ranges);
    void lay_out();

    Kernel kernel_;
    Resolution size_;
    TileGrid tiles_;
    Triangles triangles_;
    std::vector<IndexRange> ranges_;
    std::vector<BinnedRun> runs_;  ///< those in use first
    std::size_t used_ = 0;
    Bulk<std::uint32_t> lent_;  ///< to runs
    std::vector<SnappedPiece> pieces_;
    Bulk<std::uint32_t> entries_;
    std::vector<std::size_t> first_;  ///< of places_: each tile's, and their end
};

}  // namespace zproof::rasterizer
