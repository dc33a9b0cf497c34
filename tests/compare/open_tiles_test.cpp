#include "compare/first_pass/open_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace zproof {
namespace {

constexpr int width = 150, height = 70;

/// A pixel beside the others.
struct Pixel {
    bool is_open = false, differs = false, is_lawful = false;
};

/// Random pixels of random tiles, as a plane and by tile.
struct Opened {
    Plane<Pixel> plane{{width, height}};
    OpenTiles tiles{View{.name = "tiles", .camera = {}, .width = width, .height = height}};

    explicit Opened(std::mt19937& random) {
        const std::uint32_t share = random() % 4;
        for (int row = 0; row < tiles.tiles().rows; ++row)
            for (int column = 0; column < tiles.tiles().columns; ++column)
                if (random() % 4 < share) open(column, row, random);
    }

    void open(int column, int row, std::mt19937& random) {
        OpenTiles::Opened opened;
        for (int y = row * Tiles::side_px; y < std::min(height, (row + 1) * Tiles::side_px); ++y)
            for (int x = column * Tiles::side_px; x < std::min(width, (column + 1) * Tiles::side_px); ++x) {
                Pixel& pixel = plane.at(x, y);
                pixel.is_open = random() % 4 == 0;
                pixel.differs = pixel.is_open && random() % 4 != 0;
                pixel.is_lawful = pixel.differs && random() % 2 == 0;
                const ColumnMask here = ColumnMask{1} << x % Tiles::side_px;
                if (pixel.is_open) opened.pixels.add(y % Tiles::side_px, here);
                if (pixel.differs) opened.differ.add(y % Tiles::side_px, here);
                if (pixel.is_lawful) opened.lawful.add(y % Tiles::side_px, here);
            }
        if (!opened.pixels.is_none()) tiles.open(column, row, opened);
    }
    std::size_t count() const { return std::size_t(std::ranges::count_if(plane.pixels(), &Pixel::is_open)); }
};

bool differs(const OpenTiles& tiles, const PixelPlace& pixel) {
    for (const OpenTiles::Tile& tile : tiles.of_row(pixel.y / Tiles::side_px))
        if (tile.column == pixel.x / Tiles::side_px)
            return (tile.differ.row(pixel.y % Tiles::side_px) >> pixel.x % Tiles::side_px & 1) != 0;
    return false;
}

TEST(OpenTiles, AreNumberedInRasterOrder) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        Opened opened(random);
        opened.tiles.number();
        std::uint32_t next = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!opened.plane.at(x, y).is_open) continue;
                ASSERT_EQ(opened.tiles.number_of({x, y}), next);
                ASSERT_EQ(opened.tiles.is_lawful({x, y}), opened.plane.at(x, y).is_lawful);
                ASSERT_EQ(differs(opened.tiles, {x, y}), opened.plane.at(x, y).differs);
                ++next;
            }
        ASSERT_EQ(opened.tiles.count(), next);
    }
}

/// Of each tile some pixels are decided.
TEST(OpenTiles, ListWhatIsLeftTileByTile) {
    std::mt19937 random(2);
    for (int round = 0; round < 200; ++round) {
        Opened opened(random);
        const Tiles& tiles = opened.tiles.tiles();
        std::vector<PixelPlace> expected;
        for (int row = 0; row < tiles.rows; ++row) {
            int before = -1;
            for (OpenTiles::Tile& tile : opened.tiles.of_row(row)) {
                ASSERT_LT(before, tile.column);
                before = tile.column;
                for (int y = 0; y < TileMask::rows; ++y) {
                    TileMask decided;
                    decided.add(y, random() & all_columns);
                    tile.left &= ~decided;
                    for (int x = 0; x < Tiles::side_px; ++x)
                        if ((tile.pixels.row(y) & ~decided.row(y)) >> x & 1)
                            expected.push_back({tile.column * Tiles::side_px + x, row * Tiles::side_px + y});
                }
            }
        }
        EXPECT_EQ(opened.tiles.count(), opened.count()) << "what is decided was opened";
        ASSERT_TRUE(std::ranges::equal(opened.tiles.left(), expected));
    }
}

}  // namespace
}  // namespace zproof
