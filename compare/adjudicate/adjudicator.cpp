#include "compare/adjudicate/adjudicator.h"

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>

#include "compare/adjudicate/tile_work.h"

namespace zproof {

namespace {

/// Triangles are looked for so far around every pixel at first: few squares are larger.
constexpr double first_search_px = 1.0 / 16;

/// In cuts of a region by a half-plane: 7 to 36 minutes of a processor. It is shared out evenly among the
/// tiles that have pixels to decide, before any is.
constexpr std::size_t most_work_of_a_view = std::size_t{1} << 32, least_work_of_a_tile = 1 << 18;

/// A pixel at which something is to be decided, and how far triangles are looked for around it.
struct Pending {
    std::uint32_t pixel;
    double reach_px;
};

/// The pending pixels of one tile.
struct TileRange {
    std::size_t tile, first, end;
};

/// Orders them by tile, and otherwise leaves them as they are.
std::vector<TileRange> sort_by_tile(std::vector<Pending>& pending, std::span<const PixelCoord> pixels,
                                    const Tiles& tiles) {
    const auto tile_of = [&](const Pending& p) { return tiles.of(pixels[p.pixel].x, pixels[p.pixel].y); };
    std::vector<std::size_t> next(tiles.count() + 1);  // by tile: where its next one goes
    for (const Pending& p : pending) ++next[tile_of(p) + 1];
    std::vector<TileRange> ranges;
    for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
        const std::size_t first = next[tile], end = next[tile + 1] += first;
        if (first != end) ranges.push_back({tile, first, end});
    }
    std::vector<Pending> sorted(pending.size());
    for (const Pending& p : pending) sorted[next[tile_of(p)]++] = p;
    pending.swap(sorted);
    return ranges;
}

std::vector<Box> asked_boxes(std::span<const Pending> pending, std::span<const PixelCoord> pixels,
                             const Tiles& tiles) {
    std::vector<Box> asked(tiles.count());
    for (const auto& [i, reach_px] : pending) {
        const auto& [x, y] = pixels[i];
        asked[tiles.of(x, y)].add(square_around(x, y, reach_px));
    }
    return asked;
}

}  // namespace

/// What needs to look farther than was searched is asked once more.
void Adjudicator::for_each_pixel(std::span<const PixelCoord> pixels, const DoAtPixel& act) const {
    if (pixels.empty()) return;
    const Tiles tiles(view_);
    const ViewRays<double> rays(view_);
    const TriangleSearch search(scene_, view_, renderers_);
    const TileWork::Setting setting{scene_, view_, rays, search, asked_, override_};
    std::vector<Pending> pending;
    for (std::size_t i = 0; i < pixels.size(); ++i) pending.push_back({std::uint32_t(i), first_search_px});
    while (!pending.empty() && !tbb::is_current_task_group_canceling()) {
        const std::vector<TileRange> ranges = sort_by_tile(pending, pixels, tiles);
        const TrianglesByTile near = search.find(asked_boxes(pending, pixels, tiles));
        const std::size_t most_work =
            std::max(most_work_of_a_view / std::max<std::size_t>(ranges.size(), 1), least_work_of_a_tile);
        const auto do_tile = [&](std::size_t r) {
            TileWork work(setting, near.of(ranges[r].tile), most_work);
            for (std::size_t i = ranges[r].first;
                 i < ranges[r].end && !tbb::is_current_task_group_canceling(); ++i)
                pending[i].reach_px = act(work, pending[i].pixel, pending[i].reach_px);
        };
        tbb::parallel_for(std::size_t(0), ranges.size(), do_tile, tbb::simple_partitioner());
        std::erase_if(pending, [](const Pending& p) { return p.reach_px == 0; });
    }
}

std::vector<QueryResult> Adjudicator::decide(std::span<const PixelQuery> queries) const {
    std::vector<PixelCoord> pixels;
    for (const PixelQuery& query : queries) pixels.push_back({query.x, query.y});
    std::vector<QueryResult> adjudicated(queries.size());
    for_each_pixel(pixels, [&](TileWork& work, std::size_t i, double searched_px) {
        return work.decide(queries[i], searched_px, adjudicated[i]);
    });
    return adjudicated;
}

}  // namespace zproof
