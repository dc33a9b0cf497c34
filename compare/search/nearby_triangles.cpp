#include "compare/search/nearby_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "compare/search/tile_search.h"
#include "compare/search/triangle_filter.h"

namespace zproof {

void find_nearby_triangles(const Scene& scene, const View& view, std::span<Site> sites) {
    const Tiles tiles(view);
    std::vector<std::uint32_t> sites_of_tile(tiles.count());
    for (const Site& site : sites) ++sites_of_tile[tiles.of(site.x, site.y)];
    AskedTiles asked(tiles, sites_of_tile);
    for (const Site& site : sites)
        asked.add(tiles.of(site.x, site.y), square_around(site.x, site.y, site.reach_px), site.reach_px);
    const TrianglesByTile near(scene, view, asked);
    const TriangleFilters filters(view);
    tbb::parallel_for(std::size_t(0), sites.size(), [&](std::size_t i) {
        Site& site = sites[i];
        site.triangles.clear();
        for (const std::uint32_t t : near.of(tiles.of(site.x, site.y)))
            if (filters.of(corners_of(scene, t)).is_near(site.x, site.y, site.reach_px))
                site.triangles.push_back(t);
    });
}

}  // namespace zproof
