#include "compare/first_pass/open_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace zproof {

namespace {

/// Calls visit(column, y, row) for the rows of a band's tiles that have open pixels, in raster order.
template <class Band, class Visit>
void for_each_row(Band& band, int tile_row, const Visit& visit) {
    std::vector<decltype(band.data())> tiles;
    tiles.reserve(band.size());
    for (auto& tile : band) tiles.push_back(&tile);
    std::ranges::sort(tiles, {}, [](const auto* tile) { return tile->column; });
    for (std::size_t y = 0; y < Tiles::side_px; ++y)
        for (auto* const tile : tiles)
            if (tile->rows[y].pixels != 0)
                visit(tile->column, tile_row * Tiles::side_px + int(y), tile->rows[y]);
}

}  // namespace

void OpenTiles::open(int column, int y, ColumnMask pixels, ColumnMask lawful) {
    const int tile_row = y / Tiles::side_px;
    Band& band = bands_[std::size_t(tile_row)];
    std::uint16_t& place = place_[tiles_.index(column, tile_row)];
    if (place == 0) {
        band.push_back({.column = column});
        place = std::uint16_t(band.size());
    }
    OpenTile& tile = band[place - 1u];
    Row& row = tile.rows[std::size_t(y % Tiles::side_px)];
    row.pixels |= pixels;
    row.lawful |= lawful & pixels;
    tile.count += std::uint32_t(std::popcount(pixels));
}

std::vector<std::uint32_t> OpenTiles::first_of_bands() const {
    std::vector<std::uint32_t> first{0};
    for (const Band& band : bands_) {
        std::uint32_t next = first.back();
        for (const OpenTile& tile : band) next += tile.count;
        first.push_back(next);
    }
    return first;
}

std::size_t OpenTiles::number() {
    const std::vector<std::uint32_t> first = first_of_bands();
    tbb::parallel_for(std::size_t(0), bands_.size(), [&](std::size_t i) {
        std::uint32_t next = first[i];
        for_each_row(bands_[i], int(i), [&](int, int, Row& row) {
            row.first = next;
            next += std::uint32_t(std::popcount(row.pixels));
        });
    });
    return first.back();
}

std::size_t OpenTiles::tiles_open() const {
    std::size_t count = 0;
    for (const Band& band : bands_) count += band.size();
    return count;
}

std::vector<PixelPlace> OpenTiles::places() const {
    const std::vector<std::uint32_t> first = first_of_bands();
    std::vector<PixelPlace> all(first.back());
    tbb::parallel_for(std::size_t(0), bands_.size(), [&](std::size_t i) {
        PixelPlace* next = all.data() + first[i];
        for_each_row(bands_[i], int(i), [&](int column, int y, const Row& row) {
            for (ColumnMask rest = row.pixels; rest != 0; rest &= rest - 1)
                *next++ = {column * Tiles::side_px + std::countr_zero(rest), y};
        });
    });
    return all;
}

}  // namespace zproof
