#include "rasterizer/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

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

/// What one run of triangles puts into the bins.
struct TileBins::Run {
    struct Entry {
        std::uint32_t tile, triangle;  ///< the triangle's place within the run
    };
    std::vector<Entry> entries;  ///< in triangle order
    std::vector<std::uint32_t> count_by_tile;

    void add(std::size_t tile, std::size_t triangle) {
        entries.push_back({std::uint32_t(tile), std::uint32_t(triangle)});
        ++count_by_tile[tile];
    }
    void add_to_tiles(const SnappedTriangle& triangle, std::size_t place, const TileGrid& tiles,
                      const ViewSetup& setup);
};

void TileBins::Run::add_to_tiles(const SnappedTriangle& triangle, std::size_t place, const TileGrid& tiles,
                                 const ViewSetup& setup) {
    const PixelRect box = pixels_within(triangle, setup);
    const int column0 = box.x0 / tile_size, column1 = (box.x1 - 1) / tile_size;
    const int row0 = box.y0 / tile_size, row1 = (box.y1 - 1) / tile_size;
    const auto tile_at = [&](int column, int row) {
        return std::size_t(row) * std::size_t(tiles.columns) + std::size_t(column);
    };
    if (column0 == column1 && row0 == row1) return add(tile_at(column0, row0), place);
    const auto edges = edges_of(triangle, setup.fill);
    for (int row = row0; row <= row1; ++row) {
        for (int column = column0; column <= column1; ++column) {
            const std::size_t tile = tile_at(column, row);
            const PixelRect pixels = tiles.pixels(tile, setup.size);
            const auto reaches_tile = [&](const EdgeFunction& e) { return reaches(e, pixels, setup.grid); };
            if (std::ranges::all_of(edges, reaches_tile)) add(tile, place);
        }
    }
}

TileBins::TileBins(const Scene& scene, const ProjectedVertices& projected, const ViewSetup& setup)
    : tiles_(setup.size) {
    const std::size_t count = scene.triangles.size();
    const std::size_t length = run_length(count);
    std::vector<Run> runs((count + length - 1) / length);
    triangles_.resize(runs.size());
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t r) {
        const std::size_t begin = r * length, end = std::min(count, begin + length);
        auto& triangles = triangles_[r];
        triangles.reserve(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            append_snapped(triangles, scene, projected, setup, std::uint32_t(i));
        }
        runs[r].entries.reserve(triangles.size() + triangles.size() / 4);
        runs[r].count_by_tile.assign(tiles_.count(), 0);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            runs[r].add_to_tiles(triangles[i], i, tiles_, setup);
    });
    join(runs);
}

void TileBins::join(const std::vector<Run>& runs) {
    // next[r][tile]: where run r puts its next triangle of that tile.
    std::vector<std::vector<std::size_t>> next(runs.size(), std::vector<std::size_t>(tiles_.count()));
    first_.resize(tiles_.count() + 1);
    std::size_t total = 0;
    for (std::size_t tile = 0; tile < tiles_.count(); ++tile) {
        first_[tile] = total;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            next[r][tile] = total;
            total += runs[r].count_by_tile[tile];
        }
    }
    first_.back() = total;
    members_.resize(total);
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t r) {
        for (const auto [tile, triangle] : runs[r].entries) {
            members_[next[r][tile]++] = &triangles_[r][triangle];
        }
    });
}

}  // namespace zproof::rasterizer
