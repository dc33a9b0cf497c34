/// What is found of sixteen pixels together must be what is found of each, to the last bit.
#include "compare/layers/triangle_row.h"

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
void for_each_row_of_each(const Visit& visit) {
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
            for (int y = 0; y < 16 && filter.is_trusted; ++y) visit(sights, triangle, RowPlace{1, y});
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(TriangleRow, HasTheBoundsOfEachPixel) {
    int bounded = 0;
    for_each_row_of_each([&](const auto& sights, const auto& triangle, const RowPlace& at) {
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

}  // namespace
}  // namespace zproof
