#include "compare/open_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace zproof {

OpenTiles::OpenTiles(const View& view, std::span<const PixelPlace> open)
    : tiles_(view), tile_(tiles_.count()) {
    const auto first_of = [&](int row) {
        return std::size_t(std::ranges::lower_bound(open, row * Tiles::side_px, {}, &PixelPlace::y) -
                           open.begin());
    };
    tbb::parallel_for(0, tiles_.rows, [&](int tile_row) {
        const std::size_t end = first_of(tile_row + 1);
        for (std::size_t i = first_of(tile_row); i < end; ++i) {
            Tile& tile = tile_[tiles_.of(open[i].x, open[i].y)];
            Row& row = tile.rows[std::size_t(open[i].y % Tiles::side_px)];
            if (row.pixels == 0) row.first = std::uint32_t(i);
            row.pixels |= ColumnMask{1} << (open[i].x % Tiles::side_px);
            ++tile.count;
        }
    });
}

}  // namespace zproof
