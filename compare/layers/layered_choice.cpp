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

bool is_worth_it(const Comparands& of, const OpenTiles& open, int column, int row) {
    const std::uint32_t count = open.count(column, row);
    if (count < many) return false;
    std::uint32_t rows = 0;
    ColumnMask columns = 0;
    bool lie_over = false;
    for (int y = row * Tiles::side_px; y < (row + 1) * Tiles::side_px; ++y) {
        const ColumnMask pixels = open.row(column, y).pixels;
        if (pixels == 0) continue;
        ++rows;
        columns |= pixels;
        const int x = column * Tiles::side_px + std::countr_zero(pixels);
        lie_over = lie_over || lie_over_each_other(of, {x, y});
    }
    return lie_over && count >= many_of_line * std::max(rows, std::uint32_t(std::popcount(columns)));
}

/// Of a tile's open pixels, of which there are some.
Around centres_of(const OpenTiles& open, int column, int row) {
    const int left = column * Tiles::side_px, top = row * Tiles::side_px;
    ColumnMask any = 0;
    Box box;
    for (int y = top; y < top + Tiles::side_px; ++y) {
        const ColumnMask pixels = open.row(column, y).pixels;
        any |= pixels;
        if (pixels != 0) box.add(left, y);
    }
    box.add(left + int(std::bit_width(any)) - 1, box.top);
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
        for (int column = 0; column < tiles.columns; ++column) {
            if (!is_worth_it(of, open, column, row)) continue;
            const std::size_t tile = tiles.index(column, row);
            is_asked[tile] = 1;
            centres[tile] = centres_of(open, column, row);
            pixels[std::size_t(row)] += open.count(column, row);
        }
    });
    const std::size_t sum = std::accumulate(pixels.begin(), pixels.end(), std::size_t(0));
    if (triangles_per_pixel * sum < of.scene.triangles.size()) is_asked.assign(tiles.count(), 0);
    return {asked_around(centres, is_asked, tiles, reach_px), std::move(centres)};
}

/// What is to be known of a triangle costs about as much as a pixel by itself.
bool is_worth_layers(std::size_t pixels, std::size_t triangles) { return pixels >= triangles; }

}  // namespace zproof
