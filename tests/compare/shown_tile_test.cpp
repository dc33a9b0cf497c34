/// What a frame shows in a tile, inside the image and at its ends.
#include "compare/layers/shown_tile.h"

#include <gtest/gtest.h>

#include <map>

#include "random_surroundings.h"

namespace zproof {
namespace {

constexpr Resolution size{40, 20};  // the last tiles reach beyond it

Frame random_frame(Dice& dice) {
    Frame frame(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int shown = dice.below(5);
            frame.primitive.row(y)[std::size_t(x)] =
                shown == 4 ? PrimitiveId::none : PrimitiveId(std::uint32_t(shown));
            frame.camera_depth.row(y)[std::size_t(x)] = float(dice.between(1, 2));
        }
    return frame;
}

/// Some of a tile's pixels that are in the image.
TileMask some_pixels(Dice& dice, const TilePlace& tile) {
    TileMask pixels;
    const int sparse = 1 + dice.below(20);
    for (int y = 0; y < TileMask::rows && tile.top + y < size.height; ++y)
        for (int x = 0; x < int(tile_columns) && tile.left + x < size.width; ++x)
            if (dice.below(sparse) == 0) pixels.add(y, ColumnMask{1} << x);
    return pixels;
}

/// Calls visit(tile, pixels, frame) with tiles of random frames.
template <class Visit>
void for_each_tile(const Visit& visit) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const Frame frame = random_frame(dice);
        for (int top = 0; top < size.height; top += TileMask::rows)
            for (int left = 0; left < size.width; left += int(tile_columns)) {
                const TilePlace tile{left, top};
                visit(tile, some_pixels(dice, tile), frame);
                if (testing::Test::HasFatalFailure()) return;
            }
    }
}

PrimitiveId shown_at(const Frame& frame, const TilePlace& tile, int x, int y) {
    return frame.primitive.at(tile.left + x, tile.top + y);
}

TEST(ShownTile, VisitsEachTriangleOnceWhereItShows) {
    for_each_tile([](const TilePlace& tile, const TileMask& pixels, const Frame& frame) {
        const ShownTile shown(frame, tile, pixels);
        std::map<PrimitiveId, TileMask> visited;
        shown.for_each(pixels, [&](PrimitiveId triangle, const TileMask& here) {
            ASSERT_TRUE(visited.emplace(triangle, here).second);
        });
        TileMask all;
        for (const auto& [triangle, here] : visited) {
            ASSERT_EQ(all & here, TileMask{});
            all |= here;
            for_each_row(here, [&, shows = triangle](int y, ColumnMask columns) {
                for (int x = 0; x < int(tile_columns); ++x)
                    ASSERT_TRUE((columns >> x & 1) == 0 || shown_at(frame, tile, x, y) == shows);
            });
        }
        ASSERT_EQ(all, pixels);
        for_each_row(pixels, [&](int y, ColumnMask columns) {
            const TileRowOf<float> depth = shown.camera_depth(y);
            for (std::size_t x = 0; x < tile_columns; ++x)
                ASSERT_TRUE((columns >> x & 1) == 0 ||
                            depth[x] == frame.camera_depth.row(tile.top + y)[std::size_t(tile.left) + x]);
        });
    });
}

TEST(TileMask, HasItsRows) {
    TileMask mask;
    EXPECT_TRUE(mask.is_none());
    for (int y = 0; y < TileMask::rows; ++y) mask.add(y, ColumnMask(0x8001 ^ y << 3));
    std::array<std::uint16_t, TileMask::rows> rows;
    int count = 0;
    for (int y = 0; y < TileMask::rows; ++y) {
        EXPECT_EQ(mask.row(y), ColumnMask(0x8001 ^ y << 3));
        EXPECT_EQ((~mask).row(y), ~ColumnMask(0x8001 ^ y << 3) & all_columns);
        rows[std::size_t(y)] = std::uint16_t(mask.row(y));
        count += std::popcount(mask.row(y));
    }
    EXPECT_EQ(TileMask::of(rows), mask);
    EXPECT_EQ(mask.columns_of_row(), rows);
    EXPECT_EQ(mask.count(), count);
    EXPECT_FALSE(mask.is_none());
    EXPECT_TRUE((mask & ~mask).is_none());
    EXPECT_EQ(mask | ~mask, TileMask::all());
}

TEST(TileMask, KnowsWhichOfItsRowsAndColumnsHaveSome) {
    Dice dice(1);
    for (int round = 0; round < 1000; ++round) {
        TileMask mask;
        unsigned rows = 0;
        ColumnMask columns = 0;
        for (int left = dice.below(20); left > 0; --left) {
            const int y = dice.below(TileMask::rows);
            const ColumnMask here = ColumnMask(1) << dice.below(int(tile_columns));
            mask.add(y, here);
            rows |= 1u << y, columns |= here;
        }
        ASSERT_EQ(mask.rows_with_some(), rows);
        ASSERT_EQ(mask.columns_with_some(), columns);
        unsigned visited = 0;
        for_each_row(mask, [&](int y, ColumnMask of_row) {
            ASSERT_EQ(of_row, mask.row(y));
            visited |= 1u << y;
        });
        ASSERT_EQ(visited, rows);
    }
}

TEST(Masks, PutAValueWhereTheySaySo) {
    for (const ColumnMask mask : {0x0000u, 0x0001u, 0x8000u, 0xa5c3u, 0xffffu, 0x00ffu}) {
        std::array<std::uint8_t, tile_columns + 2> bytes;
        bytes.fill(7);
        put_where(mask, std::uint8_t{200}, &bytes[1]);
        for (std::size_t i = 0; i < tile_columns; ++i)
            EXPECT_EQ(bytes[i + 1], (mask >> i & 1) != 0 ? 200 : 7) << i;
        EXPECT_EQ(bytes.front(), 7);
        EXPECT_EQ(bytes.back(), 7);
    }
}

}  // namespace
}  // namespace zproof
