/// What is found of sixteen pixels together must be what is found of each, to the last bit.
#include "compare/triangle_row.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

Precision precision_of(std::uint32_t seed) {
    switch (seed % 3) {
        case 0:
            return raster_precision();
        case 1:
            return ray_precision();
        default:
            return RasterPrecision{.depth_buffer = DepthBuffer::reversed_z};
    }
}

/// Does something with every triangle of random scenes that is trusted, and every row of its image.
template <class Visit>
void for_each_row(const Visit& visit) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, precision_of(seed));
        const Sights<double> sights(s.view);
        const TriangleFilters filters(s.view);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const CornersWorld p = corners_of(s.scene, t);
            const TriangleFilter filter = filters.of(p);
            const ViewedTriangle seen(bounds, sights.at(0, 0), p);
            const TriangleOfView triangle(bounds, seen);
            for (int y = 0; y < 16 && filter.is_trusted; ++y) visit(sights, triangle, filter, RowPlace{1, y});
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(TriangleRow, HasTheBoundsOfEachPixel) {
    int bounded = 0;
    for_each_row([&](const auto& sights, const auto& triangle, const auto&, const RowPlace& at) {
        const SightRow sight(sights, at);
        const TriangleRow row(triangle.seen->image, sight);
        const TileRow eps_px = row.eps_px(triangle);
        const TriangleRow::Range range = row.nearness_range(triangle);
        for (std::size_t i = 0; i < tile_columns; ++i) {
            const Neighbour alone = neighbour_of(sights.at(at.left + int(i), at.y), triangle);
            ASSERT_EQ(eps_px[i], alone.bounds.eps_px);
            ASSERT_EQ(range.least[i], alone.least_nearness);
            ASSERT_EQ(range.greatest[i], alone.greatest_nearness);
            bounded += alone.greatest_nearness < unlimited;
        }
    });
    EXPECT_GT(bounded, 50000);
}

TEST(TriangleRow, PlacesSquaresAsOneAtATime) {
    int covering = 0, cutting = 0, missing = 0;
    for_each_row([&](const auto&, const auto&, const TriangleFilter& filter, const RowPlace& at) {
        constexpr double half_px = 1.0 / 64;
        const Around tile{at.left + 7.5, double(at.y), 7.5 + half_px, half_px};
        const PlaceMasks places = places_in_row(filter, filter.edges_within(tile), at, half_px);
        const PlaceMasks by_all = places_in_row(filter, 0b111, at, half_px);
        ASSERT_EQ(by_all.covers, places.covers);
        ASSERT_EQ(by_all.cuts, places.cuts);
        for (std::size_t i = 0; i < tile_columns; ++i) {
            const auto place = filter.place_of({double(at.left + int(i)), double(at.y), half_px, half_px});
            ASSERT_EQ((places.covers >> i & 1) != 0, place == TriangleFilter::Place::covers);
            ASSERT_EQ((places.cuts >> i & 1) != 0, place == TriangleFilter::Place::unknown);
            ++(place == TriangleFilter::Place::covers   ? covering
               : place == TriangleFilter::Place::misses ? missing
                                                        : cutting);
        }
    });
    EXPECT_GT(covering, 5000);
    EXPECT_GT(cutting, 100);
    EXPECT_GT(missing, 5000);
}

TEST(TriangleRow, OrdersTwoAsOneSquareAtATime) {
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
        constexpr double half_px = 1.0 / 64;
        for (int y = 0; y < 16; ++y) {
            const OrderMasks orders = orders_in_row(front, back, {0, y}, half_px);
            for (int x = 0; x < int(tile_columns); ++x) {
                const int order = order_in({double(x), double(y), half_px, half_px}, front, back);
                ASSERT_EQ((orders.ahead >> x & 1) != 0, order > 0);
                ASSERT_EQ((orders.behind >> x & 1) != 0, order < 0);
                ++said[std::size_t(order + 1)];
            }
        }
    }
    for (const int count : said) EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace zproof
