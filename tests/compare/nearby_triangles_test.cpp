/// The search may find too many triangles, never too few.
#include "compare/search/nearby_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "brute_force.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// Does the image of the triangle (in front of near) come within `reach_px` of the centre, in exact numbers?
/// Triangles seen edge-on have a test of their own.
bool comes_near(Neighbourhood around, double reach_px) {
    const Sight<Rational> sight(around.view, around.x, around.y);
    if (!image_of(sight, corners<Rational>(around.neighbours[0].p_world))) return false;
    around.eps_px = reach_px;
    for (Neighbour& n : around.neighbours) n.near_slack = n.far_slack = 0;
    return brute_force::Picture(around).reaches(0);
}

TEST(NearbyTriangles, NoneThatComesWithinReachIsMissing) {
    int near_ones = 0, found_ones = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        std::vector<Site> sites;
        sites.reserve(4);
        for (int i = 0; i < 4; ++i)
            sites.push_back({i ? dice.below(16) : s.x, i ? dice.below(16) : s.y, dice.below(2) * 0x1p-9, {}});
        find_nearby_triangles(s.scene, s.view, sites);
        const ViewBounds bounds(s.view, RasterPrecision{});
        for (const Site& site : sites) {
            ASSERT_TRUE(std::ranges::is_sorted(site.triangles));
            for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
                const Sight<Rational> sight(s.view, site.x, site.y);
                if (!image_of(sight, corners<Rational>(corners_of(s.scene, t)))) continue;  // edge-on: below
                const Site only{site.x, site.y, site.reach_px, {t}};
                const Neighbourhood around = neighbourhood_of(s.scene, s.view, bounds, only, site.reach_px);
                const bool found = std::ranges::count(site.triangles, t) == 1;
                const bool near = comes_near(around, site.reach_px);
                ASSERT_TRUE(found || !near) << "triangle " << t << " at " << site.x << ' ' << site.y;
                ++asked, near_ones += near, found_ones += found;
            }
        }
    }
    EXPECT_GT(near_ones, asked / 20);
    EXPECT_LT(found_ones, asked * 3 / 4) << "the search rules triangles out";
}

TEST(NearbyTriangles, EdgeOnTrianglesAreFound) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const View view = pixel_view(projection, 4, 4);
        const Scene scene = scene_of(view, {{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}});
        std::vector<Site> sites{{1, 1, 0, {}}, {3, 3, 0x1p-9, {}}};
        find_nearby_triangles(scene, view, sites);
        EXPECT_EQ(sites[0].triangles, std::vector<std::uint32_t>{0});
        EXPECT_TRUE(sites[1].triangles.empty());
    }
}

/// The same triangles, their vertices `apart` places from each other.
Scene spread(const Scene& scene, std::uint32_t apart) {
    Scene spread = scene;
    Positions& positions = spread.vertices.position_world;
    positions.assign(apart * positions.size(), glm::vec3(0));
    for (std::size_t i = 0; i < scene.vertices.position_world.size(); ++i)
        positions[apart * i] = scene.vertices.position_world[i];
    for (glm::uvec3& triangle : spread.triangles) triangle *= apart;
    return spread;
}

TEST(NearbyTriangles, AreTheSameHoweverFarApartTheirIndicesAre) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const Surroundings s = random_surroundings(seed);
        std::vector<Site> sites{{s.x, s.y, 0x1p-9, {}}, {1, 1, 0, {}}}, far_apart = sites;
        find_nearby_triangles(s.scene, s.view, sites);
        find_nearby_triangles(spread(s.scene, 100), s.view, far_apart);
        for (std::size_t i = 0; i < sites.size(); ++i)
            EXPECT_EQ(sites[i].triangles, far_apart[i].triangles) << "seed " << seed;
    }
}

/// The same triangles again and again, so many that cells of the image are marked for them.
TEST(NearbyTriangles, OfManyAreTheSameAsOfFew) {
    constexpr std::uint32_t many = 9000;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const Surroundings s = random_surroundings(seed);
        const auto count = std::uint32_t(s.scene.triangles.size());
        Scene crowd = s.scene;
        for (std::uint32_t t = count; t < many; ++t) crowd.triangles.push_back(s.scene.triangles[t % count]);
        std::vector<Site> few{{s.x, s.y, 0x1p-9, {}}, {1, 1, 0, {}}}, all = few;
        find_nearby_triangles(s.scene, s.view, few);
        find_nearby_triangles(crowd, s.view, all);
        for (std::size_t i = 0; i < few.size(); ++i) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < many; ++t)
                if (std::ranges::count(few[i].triangles, t % count) != 0) expected.push_back(t);
            EXPECT_EQ(all[i].triangles, expected) << "seed " << seed;
        }
    }
}

/// One is seen edge-on; both reach behind half the near depth.
TEST(NearbyTriangles, AreFoundFromSquaresThatNoFloatHolds) {
    View view = pixel_view(Projection::perspective, 64, 64);
    view.camera.near_depth = 0.1;
    Scene scene;
    scene.vertices.position_world = {{0, 0, -1},        {0, 0.5, -1},      {0, 0.25, 1},
                                     {3e38, 0, -0.06F}, {3e38, 1, -0.06F}, {3e38, 0, -0.04F}};
    scene.triangles = {{0, 1, 2}, {3, 4, 5}};
    for (const double reach_px : {1e39, 1e42, 1e60}) {
        std::vector<Site> sites{{32, 32, reach_px, {}}, {0, 63, reach_px, {}}};
        find_nearby_triangles(scene, view, sites);
        for (const Site& site : sites) {
            EXPECT_EQ(std::ranges::count(site.triangles, 0u), 1) << reach_px;
            EXPECT_TRUE(reach_px < 1e42 || std::ranges::count(site.triangles, 1u) == 1) << reach_px;
        }
    }
}

TEST(NearbyTriangles, ManyChunksComeInOrder) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const Scene scene = scene_of(view, std::vector<Triangle>(10'000, wall(4)));
    std::vector<Site> sites{{2, 3, 0, {7, 7}}};
    find_nearby_triangles(scene, view, sites);
    ASSERT_EQ(sites[0].triangles.size(), 10'000u);
    EXPECT_TRUE(std::ranges::is_sorted(sites[0].triangles));
}

}  // namespace
}  // namespace zproof
