#include "compare/adjudicate/adjudicator.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "compare/adjudicate/tile_work.h"

namespace zproof {

namespace {

/// Triangles are looked for so far around every pixel at first: few squares are larger.
constexpr double first_search_px = 1.0 / 16;

/// A query that is not decided yet.
struct Open {
    std::uint32_t query;
    double reach_px;
};

/// Those of one tile: from `first` to before `end`.
struct TileRange {
    std::size_t tile, first, end;
};

/// Orders them by tile, and otherwise leaves them as they are.
std::vector<TileRange> sort_by_tile(std::vector<Open>& open, std::span<const PixelQuery> queries, const Tiles& tiles) {
    const auto tile_of = [&](const Open& o) { return tiles.of(queries[o.query].x, queries[o.query].y); };
    std::vector<std::size_t> next(tiles.count() + 1);  // by tile: where its next one goes
    for (const Open& o : open) ++next[tile_of(o) + 1];
    std::vector<TileRange> ranges;
    for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
        const std::size_t first = next[tile], end = next[tile + 1] += first;
        if (first != end) ranges.push_back({tile, first, end});
    }
    std::vector<Open> sorted(open.size());
    for (const Open& o : open) sorted[next[tile_of(o)]++] = o;
    open.swap(sorted);
    return ranges;
}

std::vector<Box> asked_boxes(std::span<const Open> open, std::span<const PixelQuery> queries, const Tiles& tiles) {
    std::vector<Box> asked(tiles.count());
    for (const auto& [i, reach_px] : open) {
        const PixelQuery& query = queries[i];
        asked[tiles.of(query.x, query.y)].add(square_around(query.x, query.y, reach_px));
    }
    return asked;
}

}  // namespace

/// What needs to look farther than it was searched is looked at once more.
std::vector<Adjudicated> adjudicate(const Scene& scene, const View& view, std::span<const PixelQuery> queries,
                                    Asked asked, const RuleOverride& override) {
    std::vector<Adjudicated> adjudicated(queries.size());
    if (queries.empty()) return adjudicated;
    const Tiles tiles(view);
    const Sights<double> rays(view);
    const TriangleSearch search(scene, view);
    const TileWork::Setting setting{scene, rays, view, search, asked, override};
    std::vector<Open> open(queries.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = {std::uint32_t(i), first_search_px};
    while (!open.empty()) {
        const std::vector<TileRange> ranges = sort_by_tile(open, queries, tiles);
        const TrianglesByTile near = search.find(asked_boxes(open, queries, tiles));
        tbb::parallel_for(std::size_t(0), ranges.size(), [&](std::size_t r) {
            TileWork work(setting, near.of(ranges[r].tile));
            for (std::size_t i = ranges[r].first; i < ranges[r].end; ++i) {
                const std::uint32_t query = open[i].query;
                open[i].reach_px = work.decide(queries[query], open[i].reach_px, adjudicated[query]);
            }
        }, tbb::simple_partitioner());
        std::erase_if(open, [](const Open& o) { return o.reach_px == 0; });
    }
    return adjudicated;
}

}  // namespace zproof
