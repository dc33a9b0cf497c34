#include "compare/layers/layered_choice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <vector>

#include "compare/truth/neighbourhood.h"

namespace zproof {

namespace {

/// Open pixels of a tile from which on it is worth the trouble to look at all together, and of each row and
/// column that has any, on the average: fewer lie along a line, and mostly next to an edge.
constexpr std::uint32_t many = 8, many_of_line = 2;

/// For so many triangles of the scene a pixel by itself is as much trouble as finding those that come near.
constexpr std::size_t triangles_per_pixel = 4;

/// What both show is asked for so many tiles ahead.
constexpr std::size_t fetched_ahead = 4;

/// Do both have a corner in common, or a side with each on its own side of it? Such are seldom seen one over
/// the other.
bool lie_side_by_side(const CornersWorld& p, const CornersWorld& q) {
    std::array<std::size_t, 3> corners{};  // of p: those that are none of q's first
    std::size_t own = 0, common = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        corners[std::ranges::count(q, p[i]) == 0 ? own++ : 2 - common++] = i;
    if (common != 2) return common == 1;
    const auto is_own = [&](const glm::vec3& corner) { return std::ranges::count(p, corner) == 0; };
    const auto other = std::ranges::find_if(q, is_own);
    if (other == q.end()) return false;
    const glm::vec3 start = p[corners[1]], along = p[corners[2]] - start;
    return glm::dot(glm::cross(along, p[corners[0]] - start), glm::cross(along, *other - start)) < 0;
}

/// May both answers' triangles cover the pixel's square?
bool lie_over_each_other(const Comparands& of, const PixelPlace& at) {
    const std::size_t count = of.scene.triangles.size();
    const auto ours = std::uint32_t(of.candidate.answer_at(at.x, at.y).primitive),
               theirs = std::uint32_t(of.reference.answer_at(at.x, at.y).primitive);
    return ours < count && theirs < count &&
           !lie_side_by_side(corners_of(of.scene, ours), corners_of(of.scene, theirs));
}

TilePlace place_of(const OpenTiles::Tile& tile, int row) {
    return {tile.column * Tiles::side_px, row * Tiles::side_px};
}

/// Asks for what both show at a tile's first open pixel.
void fetch(const Comparands& of, const OpenTiles::Tile& tile, int row) {
    const auto [left, top] = place_of(tile, row);
    const int y = std::countr_zero(tile.pixels.rows_with_some());
    const int x = left + std::countr_zero(tile.pixels.row(y));
    for (const Frame* const frame : {&of.candidate.frame(), &of.reference.frame()})
        __builtin_prefetch(&frame->primitive.at(x, top + y));
}

bool has_many(const OpenTiles::Tile& tile) {
    if (tile.count < many) return false;
    const int rows = std::popcount(tile.pixels.rows_with_some()),
              columns = std::popcount(tile.pixels.columns_with_some());
    return tile.count >= many_of_line * std::uint32_t(std::max(rows, columns));
}

/// The first open pixel of some row says it.
bool lie_over_each_other(const Comparands& of, const OpenTiles::Tile& tile, int row) {
    const auto [left, top] = place_of(tile, row);
    for (unsigned rows = tile.pixels.rows_with_some(); rows != 0; rows &= rows - 1) {
        const int y = std::countr_zero(rows);
        const int x = std::countr_zero(tile.pixels.row(y));
        if (lie_over_each_other(of, {left + x, top + y})) return true;
    }
    return false;
}

/// Of its open pixels.
Around centres_of(const OpenTiles::Tile& tile, int row) {
    const auto [left, top] = place_of(tile, row);
    const unsigned rows = tile.pixels.rows_with_some(), columns = tile.pixels.columns_with_some();
    Box box;
    box.add(left + std::countr_zero(columns), top + std::countr_zero(rows));
    box.add(left + int(std::bit_width(columns)) - 1, top + int(std::bit_width(rows)) - 1);
    return {box.middle_x(), box.middle_y(), 0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top)};
}

AskedTiles asked_around(std::span<const Around> centres, std::span<const std::uint32_t> is_asked,
                        const Tiles& tiles, double reach_px) {
    AskedTiles asked(tiles, is_asked);
    for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
        if (is_asked[tile] == 0) continue;
        Around box = centres[tile];
        box.half_x += reach_px, box.half_y += reach_px;
        asked.add(tile, raster_box(box), reach_px);
    }
    return asked;
}

}  // namespace

LayeredChoice choose_layered_tiles(const Comparands& of, const OpenTiles& open, double reach_px) {
    const Tiles& tiles = open.tiles();
    Bulk<Around> centres(tiles.count());
    std::vector<std::uint32_t> is_asked(tiles.count());
    std::vector<std::size_t> pixels(std::size_t(tiles.rows));
    tbb::parallel_for(0, tiles.rows, [&](int row) {
        const std::span<const OpenTiles::Tile> band = open.of_row(row);
        for (std::size_t i = 0; i < band.size(); ++i) {
            if (i + fetched_ahead < band.size()) fetch(of, band[i + fetched_ahead], row);
            if (!has_many(band[i]) || !lie_over_each_other(of, band[i], row)) continue;
            const std::size_t tile = tiles.index(band[i].column, row);
            is_asked[tile] = 1;
            centres[tile] = centres_of(band[i], row);
            pixels[std::size_t(row)] += band[i].count;
        }
    });
    const std::size_t sum = std::accumulate(pixels.begin(), pixels.end(), std::size_t(0));
    if (triangles_per_pixel * sum < of.scene.triangles.size()) is_asked.assign(tiles.count(), 0);
    return {asked_around(centres, is_asked, tiles, reach_px), std::move(centres)};
}

/// What is to be known of a triangle costs about as much as a pixel by itself.
bool is_worth_layers(const OpenTiles::Tile& open, std::size_t triangles) { return open.count >= triangles; }

}  // namespace zproof
