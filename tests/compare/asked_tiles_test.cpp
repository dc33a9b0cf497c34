/// The tiles that are asked about are found by their places.
#include "compare/asked_tiles.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"

namespace zproof {
namespace {

TEST(AskedTiles, OfARowAreThoseBetweenItsColumns) {
    Dice dice(1);
    for (int round = 0; round < 50; ++round) {
        const Tiles tiles(Resolution{1 + dice.below(200), 1 + dice.below(200)});
        std::vector<std::uint32_t> boxes(tiles.count());
        for (std::uint32_t& of_tile : boxes) of_tile = dice.below(3) == 0 ? 1 : 0;
        AskedTiles asked(tiles, boxes);
        for (std::size_t tile = 0; tile < tiles.count(); ++tile)
            if (boxes[tile] != 0) asked.add(tile, square_around(3, 4, 0.5), 0.5);
        for (int row = 0; row < tiles.rows; ++row)
            for (int left = 0; left < tiles.columns; ++left)
                for (int right = left; right < tiles.columns; ++right) {
                    std::vector<std::uint32_t> expected, found;
                    for (int column = left; column <= right; ++column)
                        if (boxes[tiles.index(column, row)] != 0)
                            expected.push_back(std::uint32_t(tiles.index(column, row)));
                    for (const AskedTiles::Tile& tile : asked.of(row, left, right))
                        found.push_back(tile.index);
                    ASSERT_EQ(found, expected);
                }
    }
}

}  // namespace
}  // namespace zproof
