#include "compare/class_map.h"

#include <algorithm>

namespace zproof {

void ClassMap::open(int column, int row) {
    std::uint16_t& place = place_[tiles_.index(column, row)];
    if (place != 0) return;
    Bulk<Tile>& band = bands_[std::size_t(row)];
    band.push_back(Tile{});
    place = std::uint16_t(band.size());
}

Plane<PixelClass> ClassMap::plane() const {
    Plane<PixelClass> all(size_, PixelClass::agree);
    for (int row = 0; row < tiles_.rows; ++row)
        for (int column = 0; column < tiles_.columns; ++column) {
            if (place_[tiles_.index(column, row)] == 0) continue;
            const int left = column * Tiles::side_px, top = row * Tiles::side_px;
            const int right = std::min(left + Tiles::side_px, size_.width),
                      bottom = std::min(top + Tiles::side_px, size_.height);
            for (int y = top; y < bottom; ++y)
                std::copy_n(&tile_of(left, y)[in_tile(left, y)], right - left, &all.at(left, y));
        }
    return all;
}

}  // namespace zproof
