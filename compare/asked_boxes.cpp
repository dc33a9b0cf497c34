#include "compare/asked_boxes.h"

#include <algorithm>

namespace zproof {

void AskedBoxes::add(std::size_t tile, const Box& square, double reach_px) {
    constexpr std::size_t most = 32;
    if (!tiles_[tile]) tiles_[tile] = std::make_unique<Asked>();
    auto& [boxes, reach_of_all_px] = *tiles_[tile];
    reach_of_all_px = std::max(reach_of_all_px, reach_px);
    const auto has_its_place = [&](const Box& b) {
        return b.middle_x() == square.middle_x() && b.middle_y() == square.middle_y();
    };
    if (boxes.size() == most || (!boxes.empty() && has_its_place(boxes.back())))
        boxes.back().add(square);
    else
        boxes.push_back(square);
}

double AskedBoxes::reach_px() const {
    double largest = 0;
    for (const auto& tile : tiles_)
        if (tile) largest = std::max(largest, tile->reach_px);
    return largest;
}

std::size_t AskedBoxes::count() const {
    std::size_t sum = 0;
    for (const auto& tile : tiles_)
        if (tile) sum += tile->boxes.size();
    return sum;
}

AskedTiles::AskedTiles(const Tiles& tiles, const AskedBoxes& asked) : columns_(tiles.columns) {
    boxes_.reserve(asked.count());  // so that they stay where they are
    first_.reserve(std::size_t(tiles.columns + 1) * std::size_t(tiles.rows));
    for (int row = 0; row < tiles.rows; ++row) {
        for (int column = 0; column < tiles.columns; ++column) {
            first_.push_back(std::uint32_t(tiles_.size()));
            const std::size_t index = tiles.index(column, row);
            if (asked.of(index).empty()) continue;
            const std::size_t first = boxes_.size();
            FloatBox all;
            for (const Box& box : asked.of(index)) all.add(boxes_.emplace_back(FloatBox::holding(box)));
            tiles_.push_back({std::uint32_t(index), all, std::span(boxes_).subspan(first)});
        }
        first_.push_back(std::uint32_t(tiles_.size()));
    }
}

}  // namespace zproof
