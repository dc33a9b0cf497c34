/// A run of triangles, sorted into tiles by one thread: a part of TileBins (tile_bins.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rasterizer/bin_entries.h"
#include "rasterizer/projected_vertices.h"
#include "rasterizer/tile_grid.h"

namespace zproof::rasterizer {

/// What became of triangles. Whole numbers, the same for any number of threads.
struct BinTally {
    std::uint64_t triangles = 0;    ///< looked at
    std::uint64_t outside = 0;      ///< of those, by their vertices' outcodes
    std::uint64_t cut = 0;          ///< clipped by near, far or the guard band
    std::uint64_t facing_away = 0;  ///< left out by Facing::front, pieces included
    std::uint64_t set_up = 0;       ///< put into tiles, pieces included
    /// About what those cover: of each its area in whole pixels, or the image's pixels in its box where that
    /// is less.
    std::uint64_t cover_px = 0;
    std::uint64_t reached_px = 0;  ///< the image's, in tiles that any of those is in; TileBins::tally() knows

    BinTally& operator+=(const BinTally& other);
};

class BinnedRun {
  public:
    /// Memory for entries, from fill() to write(), as long as they are few enough.
    void lend(std::span<std::uint32_t> memory) { entries_.begin_in(memory); }
    /// The triangles of a range of the scene; memory was lent before. Other memory is kept from the time
    /// before.
    void fill(const Kernel& kernel, const Scene& scene, const ProjectedVertices& projected,
              const ViewSetup& setup, const IndexRange& range);

    /// A number per tile. After fill() it is how many of the range's triangles are in the tile; for write()
    /// it is which of the tile's entries is the first of them.
    std::span<std::uint32_t> next() { return next_; }
    /// Sets the place of the run's first piece, for write(). Returns how many there are.
    std::size_t put_pieces_at(std::size_t first);
    /// Writes the run's part of both: entries by tile, in order within a tile, and pieces. `first` has each
    /// tile's first place.
    void write(std::span<const std::size_t> first, std::span<std::uint32_t> entries,
               std::span<SnappedPiece> pieces);

    const BinTally& tally() const { return tally_; }

  private:
    /// Triangles one after the other in one tile.
    struct EntryRun {
        std::uint32_t tile, count;
    };
    /// Triangles on their way, until there are enough to be placed together.
    struct Queue {
        CornerLanes corners{};
        std::uint32_t place[CornerLanes::count] = {};
        int count = 0;
    };
    void add(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c, std::uint32_t place);
    void add_pieces(const Scene& scene, std::uint32_t triangle);
    void place_queue();
    void add_queue_to_tile(std::uint32_t tile, const PlacedLanes& placed);
    void add_to_tiles(int lane, const PlacedLanes& placed, std::uint32_t place);
    void add_to_tiles_reached(int lane, const PlacedLanes& placed, std::uint32_t place);
    void add_to_tile(int column, int row, std::uint32_t place) {
        go_to(tiles_.tile_at(column, row));
        entries_.push_back(place);
    }
    void go_to(std::uint32_t tile) {
        if (entry_runs_.empty() || entry_runs_.back().tile != tile) begin_entry_run(tile);
    }
    void begin_entry_run(std::uint32_t tile) {
        end_entry_run();
        entry_runs_.push_back({tile, 0});
        entry_run_begin_ = entries_.size();
    }
    void end_entry_run() {
        if (!entry_runs_.empty())
            entry_runs_.back().count = std::uint32_t(entries_.size() - entry_run_begin_);
    }
    void count_in_tiles();

    const Kernel* kernel_ = nullptr;
    const ViewSetup* setup_ = nullptr;
    TileGrid tiles_;
    std::uint32_t length_ =
        0;  ///< triangles of the scene; piece i of the run has the place length_ + i until write()
    Queue queue_;
    std::vector<SnappedPiece> pieces_;
    BinEntries entries_;                ///< in the order of drawing, once for each tile
    std::vector<EntryRun> entry_runs_;  ///< of places_
    std::size_t entry_run_begin_ = 0;   ///< of the last one
    std::vector<std::uint32_t> next_;
    std::size_t first_piece_ = 0;
    BinTally tally_;
};

}  // namespace zproof::rasterizer
