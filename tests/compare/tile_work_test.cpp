#include "compare/adjudicate/tile_work.h"

#include <gtest/gtest.h>

#include "test_scene.h"

namespace zproof {
namespace {

/// Two walls that meet before a third, at 1/4 px from a pixel's centre.
class AQuery : public testing::Test {
  protected:
    View view = pixel_view(Projection::parallel, 16, 16);
    Scene scene = scene_of(view, {wall_left_of(8.75, 4), wall_right_of(8.75, 4), wall(8)});
    ViewRays<double> rays{view};
    TriangleSearch search{scene, view, {}};
    RuleOverride none;
    TileWork::Setting setting{scene, view, rays, search, QueryDetail::displacement, none};
    std::uint32_t near[3] = {0, 1, 2};
    TileWork work{setting, near};
    ViewBounds coarse{view, RasterPrecision{.transform = Arithmetic::float64, .subpixel_bits = 0}};
    QueryResult adjudicated{{Admissibility::hole, true, 77}, 77};
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
    TileWork::Setting for_admissibility{scene, view, rays, search, QueryDetail::admissibility, none};
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

/// The third wall is hidden for certain, which only cuts tell.
TEST_F(AQuery, IsUndecidableOnceTheWorkIsSpent) {
    const PixelQuery hidden{&coarse, PrimitiveId(2), 8, 8}, visible{&coarse, PrimitiveId(1), 9, 8};
    TileWork unlimited(setting, near);
    unlimited.decide(hidden, 2, adjudicated);
    const std::size_t enough = adjudicated.decision.work + 1;
    EXPECT_GT(enough, 1u);
    TileWork limited(setting, near, enough);
    EXPECT_EQ(limited.decide(hidden, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::hidden);
    EXPECT_EQ(limited.decide(visible, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::undecidable);
    TileWork too_limited(setting, near, enough - 1);
    EXPECT_EQ(too_limited.decide(hidden, 2, adjudicated), 0);
    EXPECT_EQ(adjudicated.decision.admissibility, Admissibility::undecidable);
}

/// Statistics are not to change a verdict.
TEST_F(AQuery, IsNotPaidForByDisplacements) {
    TileWork::Setting for_admissibility{scene, view, rays, search, QueryDetail::admissibility, none};
    for (std::size_t most_work = 0; most_work < 200; ++most_work) {
        TileWork with(setting, near, most_work), without(for_admissibility, near, most_work);
        for (int x = 7; x < 11; ++x) {
            QueryResult by_with, by_without;
            with.decide({&coarse, PrimitiveId(1), x, 8}, 2, by_with);
            without.decide({&coarse, PrimitiveId(1), x, 8}, 2, by_without);
            ASSERT_EQ(by_with.decision.admissibility, by_without.decision.admissibility) << most_work;
        }
    }
}

/// What was looked at for one renderer, one pixel or one reach is not taken for another's.
TEST_F(AQuery, IsDecidedTheSameWhateverWasDecidedBefore) {
    const ViewBounds fine(view, raster_precision());
    std::vector<PixelQuery> queries;
    for (const ViewBounds* bounds : {static_cast<const ViewBounds*>(&coarse), &fine})
        for (const std::uint32_t answer : {0u, 1u, 2u, std::uint32_t(PrimitiveId::none)})
            for (const int x : {8, 9}) queries.push_back({bounds, PrimitiveId(answer), x, 8});
    const auto decided_by = [&](TileWork& by, const PixelQuery& query, double searched_px) {
        QueryResult found;
        EXPECT_EQ(by.decide(query, searched_px, found), 0);
        return found;
    };
    for (const PixelQuery& before : queries)
        for (const PixelQuery& query : queries)
            for (const double searched_px : {1.5, 2.0, 3.0}) {
                TileWork fresh(setting, near), used(setting, near);
                decided_by(used, before, 2);
                const QueryResult found = decided_by(used, query, searched_px),
                                  expected = decided_by(fresh, query, 2);
                EXPECT_EQ(found.decision.admissibility, expected.decision.admissibility);
                EXPECT_EQ(found.decision.eps_px, expected.decision.eps_px);
                EXPECT_EQ(found.displacement_over_eps, expected.displacement_over_eps);
            }
}

}  // namespace
}  // namespace zproof
