#include "rasterizer/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace zproof::rasterizer {
namespace {

/// A run is long enough to pay for its count per tile, and there are at most 64, so that the counts stay
/// small beside the image itself.
std::size_t run_length(std::size_t triangles) { return std::max<std::size_t>(2048, (triangles + 63) / 64); }

/// Entries of most ranges: small triangles lie in one tile, but for some.
std::size_t room_for(const IndexRange& range) {
    const std::size_t triangles = range.end - range.begin;
    return triangles + triangles / 3;
}

}  // namespace

void TileBins::fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup) {
    const std::size_t count = scene.triangles.size();
    const std::size_t length = run_length(count);
    ranges_.clear();
    for (std::size_t begin = 0; begin < count; begin += length) {
        const std::size_t end = std::min(count, begin + length);
        ranges_.push_back({std::uint32_t(begin), std::uint32_t(end)});
    }
    fill(scene, projected, setup, ranges_);
}

void TileBins::fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
                    std::span<const IndexRange> ranges) {
    size_ = setup.size;
    tiles_ = TileGrid(size_);
    used_ = ranges.size();
    if (runs_.size() < used_) runs_.resize(used_);
    lend_to_runs(ranges);
    tbb::parallel_for(std::size_t{0}, used_,
                      [&](std::size_t r) { runs_[r].fill(kernel_, scene, projected, setup, ranges[r]); });
    lay_out();
    if (scene.triangles.size() + pieces_.size() >= turned)
        throw std::length_error("a view of 2^31 triangles and pieces of triangles, or more");
    triangles_ = {projected.snapped().data(), scene.triangles.data(), pieces_.data(),
                  std::uint32_t(scene.triangles.size())};
    tbb::parallel_for(std::size_t{0}, used_,
                      [&](std::size_t r) { runs_[r].write(first_, entries_, pieces_); });
}

/// All of it in one array, which stands in huge pages where it is large.
void TileBins::lend_to_runs(std::span<const IndexRange> ranges) {
    std::size_t room = 0;
    for (const IndexRange& range : ranges) room += room_for(range);
    lent_.resize(room);
    std::span<std::uint32_t> left = lent_;
    for (std::size_t r = 0; r < ranges.size(); ++r) {
        const std::size_t of_run = room_for(ranges[r]);
        runs_[r].lend(left.first(of_run));
        left = left.subspan(of_run);
    }
}

/// Places entries by tile, and within a tile by run.
void TileBins::lay_out() {
    std::size_t entries = 0, pieces = 0;
    first_.resize(tiles_.count() + 1);
    for (std::size_t tile = 0; tile < tiles_.count(); ++tile) {
        first_[tile] = entries;
        std::uint32_t in_tile = 0;
        for (std::size_t r = 0; r < used_; ++r) in_tile += std::exchange(runs_[r].next()[tile], in_tile);
        entries += in_tile;
    }
    first_.back() = entries;
    for (std::size_t r = 0; r < used_; ++r) pieces += runs_[r].put_pieces_at(pieces);
    entries_.resize(entries);
    pieces_.resize(pieces);
}

BinTally TileBins::tally() const {
    BinTally sum;
    for (std::size_t r = 0; r < used_; ++r) sum += runs_[r].tally();
    for (std::size_t tile = 0; tile < tiles_.count(); ++tile)
        if (!entries_in(tile).empty()) sum.reached_px += tiles_.pixels(tile, size_).count();
    return sum;
}

}  // namespace zproof::rasterizer
