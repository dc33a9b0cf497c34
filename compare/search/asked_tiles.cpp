#include "compare/search/asked_tiles.h"

#include <algorithm>

namespace zproof {

namespace {

/// More of a tile become one.
constexpr std::uint32_t most_boxes = 32;

}  // namespace

AskedTiles::AskedTiles(const Tiles& tiles, std::span<const std::uint32_t> boxes_of_tile)
    : columns_(tiles.columns) {
    first_.reserve(std::size_t(tiles.columns + 1) * std::size_t(tiles.rows));
    std::size_t room = 0;
    for (int row = 0; row < tiles.rows; ++row) {
        for (int column = 0; column < tiles.columns; ++column) {
            first_.push_back(std::uint32_t(tiles_.size()));
            const auto index = std::uint32_t(tiles.index(column, row));
            const std::uint32_t boxes = std::min(boxes_of_tile[index], most_boxes);
            if (boxes != 0) tiles_.push_back({.index = index, .room = boxes});
            room += boxes;
        }
        first_.push_back(std::uint32_t(tiles_.size()));
    }
    boxes_.resize(room);
    FloatBox* next = boxes_.data();
    for (Tile& tile : tiles_) {
        tile.boxes = {next, 0};
        next += tile.room;
    }
}

void AskedTiles::add(std::size_t tile, const Box& square, double reach_px) {
    const std::size_t row = tile / std::size_t(columns_), column = tile % std::size_t(columns_);
    Tile& of = tiles_[first_at(int(column), int(row))];
    const FloatBox box = FloatBox::holding(square);
    of.all.add(box);
    of.reach_px = std::max(of.reach_px, reach_px);
    if (of.boxes.size() == of.room) {
        of.boxes.back().add(box);
    } else {
        of.boxes = {of.boxes.data(), of.boxes.size() + 1};
        of.boxes.back() = box;
    }
}

double AskedTiles::reach_px() const {
    double largest = 0;
    for (const Tile& tile : tiles_) largest = std::max(largest, tile.reach_px);
    return largest;
}

}  // namespace zproof
