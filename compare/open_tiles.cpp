#include "compare/open_tiles.h"

#include <bit>

namespace zproof {

void OpenTiles::open(int column, int y, ColumnMask pixels, ColumnMask lawful) {
    Row& row = row_[index(column, y)];
    row.pixels |= pixels;
    row.lawful |= lawful & pixels;
    count_[tiles_.index(column, y / Tiles::side_px)] += std::uint32_t(std::popcount(pixels));
}

std::size_t OpenTiles::number() {
    std::uint32_t count = 0;
    for (Row& row : row_) {
        row.first = count;
        if (row.pixels != 0) count += std::uint32_t(std::popcount(row.pixels));  // few are open anywhere
    }
    return count;
}

std::vector<PixelPlace> OpenTiles::places() const {
    std::vector<PixelPlace> all;
    for (int y = 0; y < height_; ++y)
        for (int column = 0; column < tiles_.columns; ++column)
            for (ColumnMask rest = row(column, y).pixels; rest != 0; rest &= rest - 1)
                all.push_back({column * Tiles::side_px + std::countr_zero(rest), y});
    return all;
}

}  // namespace zproof
