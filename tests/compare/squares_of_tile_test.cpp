/// What is found of a tile's squares together is so of each, and of those that are not next to an edge
/// nothing is left out.
#include "compare/layers/squares_of_tile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/strips/dispatch.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

constexpr double half_px = 1.0 / 64;

/// Calls visit(square, column, y) for each pixel of a tile.
template <class Visit>
void for_each_square(const TilePlace& tile, const Visit& visit) {
    for (int y = 0; y < TileMask::rows; ++y)
        for (int x = 0; x < int(tile_columns); ++x)
            visit(Around{double(tile.left + x), double(tile.top + y), half_px, half_px}, x, y);
}

/// By more than single precision rounds places of a tile.
Around widened(Around square) {
    square.half_x += 1e-4, square.half_y += 1e-4;
    return square;
}

bool has(const TileMask& mask, int x, int y) { return (mask.row(y) >> x & 1) != 0; }

TEST(SquaresOfTile, LieWhereEachDoes) {
    int covering = 0, cutting = 0, missing = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const TriangleFilters filters(s.view);
        const TilePlace tile{1, int(seed % 5)};
        const Around around{tile.left + 7.5, tile.top + 7.5, 7.5 + half_px, 7.5 + half_px};
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const TriangleFilter filter = filters.of(corners_of(s.scene, t));
            if (!filter.is_trusted) continue;
            const PlaceMasks places = places_of_squares(filter, filter.edges_within(around), tile, half_px);
            const PlaceMasks by_all = places_of_squares(filter, 0b111, tile, half_px);
            ASSERT_EQ(by_all.covers, places.covers);
            ASSERT_EQ(by_all.cuts, places.cuts);
            for_each_square(tile, [&](const Around& square, int x, int y) {
                const auto place = filter.place_of(square), of_wider = filter.place_of(widened(square));
                const bool covers = has(places.covers, x, y), cuts = has(places.cuts, x, y),
                           misses = !covers && !cuts;
                ASSERT_FALSE(covers && cuts);
                ASSERT_TRUE(!covers || place == TriangleFilter::Place::covers);
                ASSERT_TRUE(!misses || place == TriangleFilter::Place::misses);
                ASSERT_TRUE(covers || of_wider != TriangleFilter::Place::covers);
                ASSERT_TRUE(misses || of_wider != TriangleFilter::Place::misses);
                ++(covers ? covering : misses ? missing : cutting);
            });
        }
    }
    EXPECT_GT(covering, 5000);
    EXPECT_GT(cutting, 100);
    EXPECT_GT(missing, 5000);
}

TEST(SquaresOfTile, HaveTwoInTheOrderThatEachHas) {
    std::array<int, 3> said{};
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(dice.below(2) ? Projection::perspective : Projection::parallel, 16, 16);
        const Scene scene = random_walls(dice, view);
        const TriangleFilters filters(view);
        const TriangleFilter front = filters.of(corners_of(scene, 0)),
                             back = filters.of(corners_of(scene, 1));
        if (!front.is_trusted || !back.is_trusted) continue;
        const OrderMasks orders = orders_in_squares(front, back, {0, 0}, half_px);
        for_each_square({0, 0}, [&](const Around& square, int x, int y) {
            const int order = order_in(square, front, back),
                      of_wider = order_in(widened(square), front, back);
            const bool ahead = has(orders.ahead, x, y), behind = has(orders.behind, x, y);
            ASSERT_TRUE(!ahead || order > 0);
            ASSERT_TRUE(!behind || order < 0);
            ASSERT_TRUE(ahead || of_wider <= 0);
            ASSERT_TRUE(behind || of_wider >= 0);
            ++said[behind ? 0 : ahead ? 2 : 1];
        });
    }
    for (const int count : said) EXPECT_GT(count, 1000);
}

/// Lines through a tile, some of whose values are as far from 0 as they may be off, or nothing that can be
/// compared.
strips::Signed some_line(Dice& dice) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN(),
                     infinite = std::numeric_limits<double>::infinity();
    strips::Signed line{.a = double(dice.below(9) - 4),
                        .b = double(dice.below(9) - 4),
                        .left = 16 * dice.below(100),
                        .top = 16 * dice.below(100)};
    if (dice.below(2) != 0) {
        const double scale = std::exp(dice.between(-60, 60));
        line.a = dice.between(-4, 4) * scale, line.b = dice.between(-4, 4) * scale;
    }
    line.c = -line.a * (line.left + dice.below(20)) - line.b * (line.top + dice.below(20));
    line.unsure = dice.below(2) != 0 ? dice.below(3) : dice.between(0, 4) * std::abs(line.a);
    if (dice.below(2) != 0) {  // at some pixel as unsure as may be, but for what single precision rounds
        const double limit = line.unsure * (dice.below(2) != 0 ? 1 : -1);
        const double x = line.left + dice.below(16), y = line.top + dice.below(16);
        line.c = limit - line.a * x - line.b * y;
        line.c += dice.between(-1, 1) * 1e-6 * (std::abs(line.a) + std::abs(line.b));
    }
    if (dice.below(20) == 0) line.c = none;
    if (dice.below(20) == 0) line.a = infinite;
    if (dice.below(20) == 0) line.unsure = infinite;
    return line;
}

TEST(StripKernels, TellTheSignsOfALineInATile) {
    int above = 0, below = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const strips::Signed line = some_line(dice);
        const double margin = 1e-4 * (std::abs(line.a) + std::abs(line.b) + line.unsure) + 1e-37;
        strips::Signs of_scalar;
        strips::scalar::kernel.set_signs(line, of_scalar);
        for (const strips::Kernel& kernel : strips::available_kernels()) {
            SCOPED_TRACE(kernel.name);
            strips::Signs signs;
            kernel.set_signs(line, signs);
            for (int y = 0; y < strips::Signs::side; ++y)
                for (int x = 0; x < strips::Signs::side; ++x) {
                    const double value = line.a * (line.left + x) + line.b * (line.top + y) + line.c;
                    const bool is_above = (signs.above[y] >> x & 1) != 0,
                               is_below = (signs.below[y] >> x & 1) != 0;
                    ASSERT_TRUE(!is_above || value - line.unsure > 0) << x << ", " << y;
                    ASSERT_TRUE(!is_below || value + line.unsure < 0) << x << ", " << y;
                    ASSERT_TRUE(is_above || !(value - line.unsure > margin)) << x << ", " << y;
                    ASSERT_TRUE(is_below || !(value + line.unsure < -margin)) << x << ", " << y;
                    ASSERT_EQ(signs.above[y], of_scalar.above[y]);
                    ASSERT_EQ(signs.below[y], of_scalar.below[y]);
                    above += signs.above[y] >> x & 1, below += signs.below[y] >> x & 1;
                }
        }
    }
    EXPECT_GT(above, 50'000);
    EXPECT_GT(below, 50'000);
}

}  // namespace
}  // namespace zproof
