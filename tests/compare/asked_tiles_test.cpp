/// The tiles that are asked about are found by their places.
#include "compare/search/asked_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(AskedTiles, HoldEveryBoxHoweverMany) {
    const Tiles tiles(Resolution{40, 20});
    for (const std::uint32_t count : {1u, 31u, 32u, 33u, 200u}) {
        std::vector<std::uint32_t> boxes_of_tile(tiles.count());
        boxes_of_tile[1] = count, boxes_of_tile[2] = 1;
        AskedTiles asked(tiles, boxes_of_tile);
        asked.add(2, square_around(35, 3, 2), 2);
        for (std::uint32_t i = 0; i < count; ++i) asked.add(1, square_around(16 + int(i % 16), 3, i), i);
        ASSERT_EQ(asked.all().size(), 2u);
        const AskedTiles::Tile& tile = asked.all()[0];
        EXPECT_LE(tile.boxes.size(), 32u);
        for (std::uint32_t i = 0; i < count; ++i) {
            const FloatBox square = FloatBox::holding(square_around(16 + int(i % 16), 3, i));
            const auto holds = [&](FloatBox box) {
                const FloatBox before = box;
                box.add(square);
                return box.in_double().left == before.in_double().left &&
                       box.in_double().right == before.in_double().right &&
                       box.in_double().top == before.in_double().top &&
                       box.in_double().bottom == before.in_double().bottom;
            };
            EXPECT_TRUE(holds(tile.all));
            EXPECT_TRUE(std::ranges::any_of(tile.boxes, holds)) << i << " of " << count;
        }
        EXPECT_EQ(asked.all()[1].boxes.size(), 1u);
        EXPECT_EQ(asked.reach_px(), std::max(2.0, count - 1.0));
        EXPECT_TRUE(asked.has(1, 0));
        EXPECT_FALSE(asked.has(0, 0));
    }
}

}  // namespace
}  // namespace zproof
