#include "compare/first_pass/open_tiles.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <functional>
#include <numeric>

namespace zproof {

namespace {

/// Of each band the sum of what comes before it; at the end, of all. `count` is asked for every tile.
template <class Bands, class Count>
std::vector<std::size_t> sums_before(const Bands& bands, const Count& count) {
    std::vector<std::size_t> sums{0};
    for (const auto& band : bands)
        sums.push_back(std::transform_reduce(band.begin(), band.end(), sums.back(), std::plus<>(), count));
    return sums;
}

std::size_t opened_in(const OpenTiles::Tile& tile) { return tile.count; }
std::size_t left_in(const OpenTiles::Tile& tile) { return std::size_t(tile.left.count()); }

}  // namespace

void OpenTiles::open(int column, int tile_row, const Opened& opened) {
    const auto& [pixels, differ, lawful] = opened;
    std::vector<Tile>& band = bands_[std::size_t(tile_row)];
    assert(!pixels.is_none() && (band.empty() || band.back().column < column));
    band.push_back({column, std::uint32_t(pixels.count()), pixels, differ, lawful, pixels, {}});
    place_[tiles_.index(column, tile_row)] = std::uint16_t(band.size());
}

void OpenTiles::number() {
    const std::vector<std::size_t> first = sums_before(bands_, opened_in);
    tbb::parallel_for(std::size_t(0), bands_.size(), [&](std::size_t i) {
        auto next = std::uint32_t(first[i]);
        for (int y = 0; y < TileMask::rows; ++y)
            for (Tile& tile : bands_[i]) {
                tile.first[std::size_t(y)] = next;
                next += std::uint32_t(std::popcount(tile.pixels.row(y)));
            }
    });
}

std::size_t OpenTiles::count() const { return sums_before(bands_, opened_in).back(); }

Bulk<PixelPlace> OpenTiles::left() const {
    const std::vector<std::size_t> first = sums_before(bands_, left_in);
    Bulk<PixelPlace> all(first.back());
    tbb::parallel_for(std::size_t(0), bands_.size(), [&](std::size_t i) {
        PixelPlace* next = all.data() + first[i];
        for (const Tile& tile : bands_[i])
            for_each_row(tile.left, [&](int y, ColumnMask rest) {
                for (; rest != 0; rest &= rest - 1)
                    *next++ = {tile.column * Tiles::side_px + std::countr_zero(rest),
                               int(i) * Tiles::side_px + y};
            });
    });
    return all;
}

std::uint32_t OpenTiles::number_of(const PixelPlace& pixel) const {
    const auto [column, y] = in_tile(pixel);
    return number_in(tile_of(pixel), column, y);
}

std::uint32_t number_in(const OpenTiles::Tile& tile, int column, int y) {
    const ColumnMask before = tile.pixels.row(y) & ((ColumnMask{1} << column) - 1);
    return tile.first[std::size_t(y)] + std::uint32_t(std::popcount(before));
}

}  // namespace zproof
