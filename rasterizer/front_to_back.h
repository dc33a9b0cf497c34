/// The order in which hierarchical z hides most of a tile: the nearest triangles first.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <span>
#include <vector>

#include "math/bulk.h"
#include "rasterizer/tile.h"
#include "rasterizer/tile_bins.h"

namespace zproof::rasterizer {

/// Does it save more than it costs? Putting a triangle in order costs about as much as drawing a small one,
/// which it saves where it has many pixels and others hide most of them: measured in docs/performance.md.
bool front_to_back_pays(const BinTally& tally);

class FrontToBack {
  public:
    /// Looks at every triangle of the bins, on the threads of the surrounding tbb::task_arena. Memory is kept
    /// from the time before.
    void fill(const TileBins& bins);

    /// A tile's entries in order, roughly: in up to 256 steps from its nearest triangle to its farthest.
    /// Valid until this thread asks for another tile's.
    TileEntries ordered(std::span<const std::uint32_t> entries);

  private:
    /// What a thread has for the tile that it draws.
    struct Ordered {
        std::vector<std::uint32_t> distance;  ///< of each entry as it came
        std::vector<std::uint32_t> entries;   ///< in order
        std::vector<float> nearest_left;
    };
    void put_in_order(std::span<const std::uint32_t> entries, Ordered& ordered) const;
    void find_nearest_left(Ordered& ordered) const;

    float nearest(std::uint32_t entry) const { return nearest_[entry & ~turned]; }

    Bulk<float> nearest_;  ///< by entry: nearest_pixel(). Of entries in no tile it means nothing
    tbb::enumerable_thread_specific<Ordered> ordered_;
};

}  // namespace zproof::rasterizer
