/// Cells may hold too much, never too little of what is asked about.
#include "compare/search/asked_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_surroundings.h"

namespace zproof {
namespace {

View image(int width, int height) {
    View view;
    view.width = width, view.height = height;
    return view;
}

TEST(AskedCells, HoldWhateverMeetsABoxThatIsAsked) {
    constexpr double beyond_px = 40, cell_px = 4;
    int met = 0, none = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = image(1 + dice.below(300), 1 + dice.below(300));
        const Tiles tiles(view);
        std::vector<std::uint32_t> boxes_of_tile(tiles.count());
        std::vector<PixelPlace> places;
        for (int i = 0; i < 12; ++i) {
            places.push_back({dice.below(view.width), dice.below(view.height)});
            ++boxes_of_tile[tiles.of(places.back().x, places.back().y)];
        }
        AskedTiles asked(tiles, boxes_of_tile);
        std::vector<FloatBox> squares;
        for (const PixelPlace& at : places) {
            const double reach_px = dice.between(0, 3);
            const Box square = square_around(at.x, at.y, reach_px);
            asked.add(tiles.of(at.x, at.y), square, reach_px);
            squares.push_back(FloatBox::holding(square));
        }
        const AskedCells cells(view, asked);
        for (int i = 0; i < 200; ++i) {
            const double x = dice.between(-beyond_px, view.width + beyond_px),
                         y = dice.between(-beyond_px, view.height + beyond_px);
            const double side = dice.below(2) != 0 ? dice.between(0, 4) : dice.between(0, 60);
            const FloatBox box = FloatBox::holding({x, y, x + side, y + side});
            const FloatBox wider = FloatBox::holding(
                {x - 2 * cell_px, y - 2 * cell_px, x + side + 2 * cell_px, y + side + 2 * cell_px});
            const auto meets = [&](const FloatBox& b) {
                return std::ranges::any_of(squares, [&](const FloatBox& square) { return b.meets(square); });
            };
            ASSERT_TRUE(cells.any(box) || !meets(box));
            const bool is_inside = x > 0 && y > 0 && x + side < view.width && y + side < view.height;
            ASSERT_TRUE(!is_inside || !cells.any(box) || meets(wider));
            met += meets(box), none += !cells.any(box);
        }
    }
    EXPECT_GT(met, 1000);
    EXPECT_GT(none, 10'000);
}

/// As many as a sum of them forgets.
TEST(AskedCells, HoldSomethingWhereAllOf256Times256Do) {
    constexpr int side = 1024;
    const View view = image(side, side);
    const Tiles tiles(view);
    AskedTiles asked(tiles, std::vector<std::uint32_t>(tiles.count(), 1));
    for (int y = 8; y < side; y += 16)
        for (int x = 8; x < side; x += 16) asked.add(tiles.of(x, y), square_around(x, y, 7.75), 7.75);
    EXPECT_TRUE(AskedCells(view, asked).any(FloatBox(-64, -64, 4 * side, 4 * side)));
}

}  // namespace
}  // namespace zproof
