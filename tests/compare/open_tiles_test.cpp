#include "compare/first_pass/open_tiles.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace zproof {
namespace {

constexpr int width = 150, height = 70;

/// A pixel beside the others.
struct Pixel {
    bool is_open = false, is_lawful = false;
};

/// Random pixels of random rows of tiles, opened in any order, as a plane and by tile.
struct Opened {
    Plane<Pixel> plane{{width, height}};
    OpenTiles tiles{View{.name = "tiles", .camera = {}, .width = width, .height = height}};

    explicit Opened(std::mt19937& random) {
        const auto rows = random() % 60;
        for (std::uint32_t i = 0; i < rows; ++i) {
            const int column = int(random() % std::uint32_t(tiles.tiles().columns)),
                      y = int(random() % height);
            ColumnMask pixels = random() & random() & all_columns, lawful = random() & all_columns;
            for (int bit = 0; bit < Tiles::side_px; ++bit) {
                const int x = column * Tiles::side_px + bit;
                const ColumnMask here = ColumnMask{1} << bit;
                if (x >= width || plane.at(x, y).is_open) pixels &= ~here;
                if ((pixels & here) != 0) plane.at(x, y) = {true, (lawful & here) != 0};
            }
            if (pixels != 0) tiles.open(column, y, pixels, lawful);
        }
    }
};

TEST(OpenTiles, AreNumberedInRasterOrder) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        Opened opened(random);
        const std::size_t count = opened.tiles.number();
        const std::vector<PixelPlace> places = opened.tiles.places();
        ASSERT_EQ(places.size(), count);
        std::size_t next = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!opened.plane.at(x, y).is_open) continue;
                ASSERT_LT(next, count);
                ASSERT_EQ(places[next].x, x);
                ASSERT_EQ(places[next].y, y);
                const OpenTiles::Row& row = opened.tiles.row(x / Tiles::side_px, y);
                const ColumnMask before = row.pixels & ((ColumnMask{1} << x % Tiles::side_px) - 1);
                ASSERT_EQ(row.first + std::uint32_t(std::popcount(before)), next);
                ASSERT_EQ(opened.tiles.is_lawful({x, y}), opened.plane.at(x, y).is_lawful);
                ++next;
            }
        ASSERT_EQ(next, count);
    }
}

TEST(OpenTiles, CountWhatIsOpenInEach) {
    std::mt19937 random(2);
    for (int round = 0; round < 200; ++round) {
        const Opened opened(random);
        const Tiles& tiles = opened.tiles.tiles();
        std::size_t with_any = 0;
        for (int row = 0; row < tiles.rows; ++row)
            for (int column = 0; column < tiles.columns; ++column) {
                std::uint32_t expected = 0;
                for (int y = row * Tiles::side_px; y < std::min(height, (row + 1) * Tiles::side_px); ++y)
                    for (int x = column * Tiles::side_px; x < std::min(width, (column + 1) * Tiles::side_px);
                         ++x)
                        expected += opened.plane.at(x, y).is_open ? 1 : 0;
                ASSERT_EQ(opened.tiles.count(column, row), expected);
                with_any += expected != 0 ? 1 : 0;
            }
        ASSERT_EQ(opened.tiles.tiles_open(), with_any);
    }
}

}  // namespace
}  // namespace zproof
