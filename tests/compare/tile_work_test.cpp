#include "compare/adjudicate/tile_work.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

TEST(TriangleCache, KnowsTheTrianglesThatAreNear) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const Scene scene = scene_of(view, std::vector<Triangle>(12, wall(4)));
    const std::uint32_t near[] = {1, 4, 9};
    const TriangleCache cache(scene, near);
    EXPECT_EQ(cache.count(), 3u);
    EXPECT_EQ(cache.place_of(PrimitiveId(1)), 0u);
    EXPECT_EQ(cache.place_of(PrimitiveId(9)), 2u);
    for (const std::uint32_t other : {0u, 5u, 10u, std::uint32_t(PrimitiveId::none)})
        EXPECT_FALSE(cache.place_of(PrimitiveId(other))) << other;
    EXPECT_EQ(cache.triangle(1), 4u);
}

/// Asked in turn about renderers and triangles, each is that triangle's by that renderer's bounds.
TEST(TriangleCache, KeepsRenderersApart) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = scene_of(view, {wall(2), wall(4), wall(8)});
    const std::uint32_t near[] = {0, 1, 2};
    const std::vector<ViewBounds> renderers{ViewBounds(view, raster_precision()), ViewBounds(view, ray_precision()),
                                            ViewBounds(view, RasterPrecision{.subpixel_bits = 2})};
    TriangleCache cache(scene, near);
    Dice dice(1);
    for (int i = 0; i < 60; ++i) {
        const auto place = std::size_t(dice.below(3));
        const ViewBounds& bounds = renderers[std::size_t(dice.below(3))];
        const BoundedTriangle found = cache.of(place, bounds), expected(bounds, corners_of(scene, near[place]));
        EXPECT_EQ(found.p_world, expected.p_world);
        EXPECT_EQ(found.bounds.eps_base_px, expected.bounds.eps_base_px);
        EXPECT_EQ(found.bounds.eps_per_nearness, expected.bounds.eps_per_nearness);
        EXPECT_EQ(found.bounds.depth_factor, expected.bounds.depth_factor);
        EXPECT_EQ(found.keeps_to_corners, expected.keeps_to_corners);
    }
}

/// Two walls that meet before a third, at 1/4 px from a pixel's centre.
class AQuery : public testing::Test {
  protected:
    View view = pixel_view(Projection::parallel, 16, 16);
    Scene scene = scene_of(view, {wall_left_of(8.75, 4), wall_right_of(8.75, 4), wall(8)});
    Sights<double> rays{view};
    TriangleSearch search{scene, view};
    RuleOverride none;
    TileWork::Setting setting{scene, rays, view, search, Asked::displacement, none};
    std::uint32_t near[3] = {0, 1, 2};
    TileWork work{setting, near};
    ViewBounds coarse{view, RasterPrecision{.transform = Arithmetic::float64, .subpixel_bits = 0}};
    Adjudicated adjudicated{{Admissibility::hole, true, 77}, 77};
};

TEST_F(AQuery, IsLeftOpenWhereItLooksFartherThanWasSearched) {
    const double reach_px = work.decide({&coarse, PrimitiveId(1), 8, 8}, 1.0 / 16, adjudicated);
    EXPECT_GE(reach_px, 0.5);
    EXPECT_EQ(adjudicated.decision.eps_px, 77) << "untouched";
    EXPECT_EQ(work.decide({&coarse, PrimitiveId(1), 8, 8}, reach_px, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::visible);
    EXPECT_NEAR(adjudicated.decision.eps_px, 0.5, 1e-9);
    EXPECT_NEAR(*adjudicated.displacement_over_eps, 0.5, 1.0 / 512);
}

TEST_F(AQuery, SaysHowFarItMovedOnlyWhereItIsVisible) {
    EXPECT_EQ(work.decide({&coarse, PrimitiveId(2), 8, 8}, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::hidden);
    EXPECT_FALSE(adjudicated.displacement_over_eps);
}

TEST_F(AQuery, SaysHowFarItMovedOnlyWhereThatIsAsked) {
    TileWork::Setting for_admissibility{scene, rays, view, search, Asked::admissibility, none};
    TileWork plain(for_admissibility, near);
    EXPECT_EQ(plain.decide({&coarse, PrimitiveId(1), 8, 8}, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::visible);
    EXPECT_FALSE(adjudicated.displacement_over_eps);
}

/// Such a triangle does not come near: its own eps is known all the same.
TEST_F(AQuery, MayBeOfATriangleThatIsNotNear) {
    const std::uint32_t some[] = {0, 2};
    TileWork of_some(setting, some);
    EXPECT_EQ(of_some.decide({&coarse, PrimitiveId(1), 2, 8}, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::outside);
    EXPECT_NEAR(adjudicated.decision.eps_px, 0.5, 1e-9);
}

}  // namespace
}  // namespace zproof
