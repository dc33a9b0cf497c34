#include "rasterizer/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace zproof::rasterizer {
namespace {

/// A run is long enough to pay for its count per tile, and there are at most 64, so that the counts stay
/// small beside the image itself.
std::size_t run_length(std::size_t triangles) { return std::max<std::size_t>(2048, (triangles + 63) / 64); }

/// Can any sample of the rectangle be on the inner side? E is affine, so its corners decide.
bool reaches(const EdgeFunction& edge, const PixelRect& pixels, const SubpixelGrid& grid) {
    const int x = edge.a > 0 ? pixels.x1 - 1 : pixels.x0;
    const int y = edge.b > 0 ? pixels.y1 - 1 : pixels.y0;
    return edge.covers({grid.sample(x), grid.sample(y)});
}

}  // namespace

PixelRect TileGrid::pixels(std::size_t tile, Resolution size) const {
    const int x0 = int(tile % std::size_t(columns)) * tile_size;
    const int y0 = int(tile / std::size_t(columns)) * tile_size;
    return {x0, y0, std::min(x0 + tile_size, size.width), std::min(y0 + tile_size, size.height)};
}

void BinnedRun::fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
                     std::size_t begin, std::size_t end) {
    tiles_ = TileGrid(setup.size);
    pieces_.clear();
    entries_.clear();
    first_.assign(tiles_.count() + 1, 0);
    run_ = {projected.snapped.data(), scene.triangles.data() + begin, nullptr, std::uint32_t(begin),
            std::uint32_t(end - begin)};
    for (std::size_t i = begin; i < end; ++i) {
        const glm::uvec3 index = scene.triangles[i];
        const Remains remains = remains_of(index, projected);
        const auto& v = projected.snapped;
        if (remains == Remains::whole)
            add({v[index.x].p, v[index.y].p, v[index.z].p}, std::uint32_t(i - begin), setup);
        if (remains != Remains::cut) continue;
        const std::size_t first = pieces_.size();
        append_pieces(pieces_, scene, setup, std::uint32_t(i));
        add_pieces(first, setup);
    }
    run_.pieces = pieces_.data();
    sort();
}

void BinnedRun::add_pieces(std::size_t first, const ViewSetup& setup) {
    for (std::size_t i = first; i < pieces_.size(); ++i) {
        const auto& [v, id] = pieces_[i];
        add({v[0].p, v[1].p, v[2].p}, run_.length + std::uint32_t(i), setup);
    }
}

void BinnedRun::add(const Corners& corners, std::uint32_t place, const ViewSetup& setup) {
    if (const auto triangle = placed(corners, setup))
        add_to_tiles(*triangle, triangle->was_counter ? place | turned : place, setup);
}

void BinnedRun::add_to_tile(std::size_t tile, std::uint32_t place) {
    entries_.push_back({std::uint32_t(tile), place});
    ++first_[tile];
}

void BinnedRun::add_to_tiles(const Placed& triangle, std::uint32_t place, const ViewSetup& setup) {
    const PixelRect& box = triangle.pixels;
    const int column0 = box.x0 / tile_size, column1 = (box.x1 - 1) / tile_size;
    const int row0 = box.y0 / tile_size, row1 = (box.y1 - 1) / tile_size;
    const auto tile_at = [&](int column, int row) {
        return std::size_t(row) * std::size_t(tiles_.columns) + std::size_t(column);
    };
    if (column0 == column1 && row0 == row1) return add_to_tile(tile_at(column0, row0), place);
    const auto edges = edges_of(triangle.corners, setup.fill);
    for (int row = row0; row <= row1; ++row) {
        for (int column = column0; column <= column1; ++column) {
            const std::size_t tile = tile_at(column, row);
            const PixelRect pixels = tiles_.pixels(tile, setup.size);
            const auto reaches_tile = [&](const EdgeFunction& e) { return reaches(e, pixels, setup.grid); };
            if (std::ranges::all_of(edges, reaches_tile)) add_to_tile(tile, place);
        }
    }
}

/// By tile; within a tile the order stays.
void BinnedRun::sort() {
    std::uint32_t total = 0;
    for (std::uint32_t& count : first_) total += std::exchange(count, total);
    next_ = first_;
    places_.resize(total);
    for (const auto& [tile, place] : entries_) places_[next_[tile]++] = place;
}

void TileBins::fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup) {
    const std::size_t count = scene.triangles.size();
    const std::size_t length = run_length(count);
    std::vector<Range> ranges;
    for (std::size_t begin = 0; begin < count; begin += length) {
        const std::size_t end = std::min(count, begin + length);
        ranges.push_back({std::uint32_t(begin), std::uint32_t(end)});
    }
    fill(scene, projected, setup, ranges);
}

void TileBins::fill(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup,
                    std::span<const Range> ranges) {
    tiles_ = TileGrid(setup.size);
    used_ = ranges.size();
    if (runs_.size() < used_) runs_.resize(used_);
    tbb::parallel_for(std::size_t{0}, used_, [&](std::size_t r) {
        runs_[r].fill(scene, projected, setup, ranges[r].begin, ranges[r].end);
    });
}

bool TileBins::is_empty(std::size_t tile) const {
    return std::ranges::all_of(runs(), [&](const BinnedRun& run) { return run.places_in(tile).empty(); });
}

}  // namespace zproof::rasterizer
