/// The search may find too many triangles, never too few.
#include "compare/adjudicate/triangle_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "brute_force.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// Does the image of the triangle (in front of near) come within `reach_px` of the centre, in exact numbers?
/// Triangles seen edge-on have a test of their own.
bool comes_near(Neighbourhood around, double reach_px) {
    const ViewRay<Rational> ray(around.view, around.x, around.y);
    if (!image_of(ray, corners<Rational>(around.neighbours[0].p_world))) return false;
    around.eps_px = reach_px;
    for (Neighbour& n : around.neighbours) n.near_slack = n.far_slack = 0;
    return brute_force::Picture(around).reaches(0);
}

TEST(NearbyTriangles, NoneThatComesWithinReachIsMissing) {
    int near_ones = 0, found_ones = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Rng rng(seed);
        std::vector<SearchPixel> search_pixels;
        search_pixels.reserve(4);
        for (int i = 0; i < 4; ++i)
            search_pixels.push_back(
                {i ? rng.below(16) : s.x, i ? rng.below(16) : s.y, rng.below(2) * 0x1p-9, {}});
        find_nearby_triangles(s.scene, s.view, {}, search_pixels);
        const ViewBounds bounds(s.view, RasterPrecision{});
        for (const SearchPixel& search_pixel : search_pixels) {
            ASSERT_TRUE(std::ranges::is_sorted(search_pixel.triangles));
            for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
                const ViewRay<Rational> ray(s.view, search_pixel.x, search_pixel.y);
                if (!image_of(ray, corners<Rational>(corners_of(s.scene, t)))) continue;  // edge-on: below
                const SearchPixel only{search_pixel.x, search_pixel.y, search_pixel.reach_px, {t}};
                const Neighbourhood around =
                    neighbourhood_of(s.scene, s.view, bounds, only, search_pixel.reach_px);
                const bool found = std::ranges::count(search_pixel.triangles, t) == 1;
                const bool near = comes_near(around, search_pixel.reach_px);
                ASSERT_TRUE(found || !near)
                    << "triangle " << t << " at " << search_pixel.x << ' ' << search_pixel.y;
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
        std::vector<SearchPixel> search_pixels{{1, 1, 0, {}}, {3, 3, 0x1p-9, {}}};
        find_nearby_triangles(scene, view, {}, search_pixels);
        EXPECT_EQ(search_pixels[0].triangles, std::vector<std::uint32_t>{0});
        EXPECT_TRUE(search_pixels[1].triangles.empty());
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
        std::vector<SearchPixel> search_pixels{{s.x, s.y, 0x1p-9, {}}, {1, 1, 0, {}}},
            far_apart = search_pixels;
        find_nearby_triangles(s.scene, s.view, {}, search_pixels);
        find_nearby_triangles(spread(s.scene, 100), s.view, {}, far_apart);
        for (std::size_t i = 0; i < search_pixels.size(); ++i)
            EXPECT_EQ(search_pixels[i].triangles, far_apart[i].triangles) << "seed " << seed;
    }
}

/// The same triangles again and again, in many chunks.
TEST(NearbyTriangles, OfManyAreTheSameAsOfFew) {
    constexpr std::uint32_t many = 9000;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const Surroundings s = random_surroundings(seed);
        const auto count = std::uint32_t(s.scene.triangles.size());
        Scene crowd = s.scene;
        for (std::uint32_t t = count; t < many; ++t) crowd.triangles.push_back(s.scene.triangles[t % count]);
        std::vector<SearchPixel> few{{s.x, s.y, 0x1p-9, {}}, {1, 1, 0, {}}}, all = few;
        find_nearby_triangles(s.scene, s.view, {}, few);
        find_nearby_triangles(crowd, s.view, {}, all);
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
        std::vector<SearchPixel> search_pixels{{32, 32, reach_px, {}}, {0, 63, reach_px, {}}};
        find_nearby_triangles(scene, view, {}, search_pixels);
        for (const SearchPixel& search_pixel : search_pixels) {
            EXPECT_EQ(std::ranges::count(search_pixel.triangles, 0u), 1) << reach_px;
            EXPECT_TRUE(reach_px < 1e42 || std::ranges::count(search_pixel.triangles, 1u) == 1) << reach_px;
        }
    }
}

TEST(NearbyTriangles, ManyChunksComeInOrder) {
    const View view = pixel_view(Projection::parallel, 4, 4);
    const Scene scene = scene_of(view, std::vector<Triangle>(10'000, wall(4)));
    std::vector<SearchPixel> search_pixels{{2, 3, 0, {7, 7}}};
    find_nearby_triangles(scene, view, {}, search_pixels);
    ASSERT_EQ(search_pixels[0].triangles.size(), 10'000u);
    EXPECT_TRUE(std::ranges::is_sorted(search_pixels[0].triangles));
}

using Point = std::array<Rational, 2>;

/// In the image; of a place that lies before the eye.
Point raster_of(const ViewRay<Rational>& ray, const Vector3<Rational>& p_world, const PixelCoord& place) {
    const auto v = p_world - ray.origin;
    const Rational all = dot(ray.step_x, cross(ray.step_y, ray.direction));
    const Rational t = dot(ray.step_x, cross(ray.step_y, v)) / all;
    const Rational d = ray.projection == Projection::perspective ? t : Rational(1);
    const Rational x = dot(v, cross(ray.step_y, ray.direction)) / all / d,
                   y = dot(ray.step_x, cross(v, ray.direction)) / all / d;
    return {x + Rational(place.x + 0.5), y + Rational(place.y + 0.5)};
}

/// The corners of what a triangle shows from that depth on, exactly.
std::vector<Point> shown_corners(const View& view, const CornersWorld& p_world, const Rational& near) {
    const ViewRay<Rational> ray(view, 0, 0);
    const Corners<Rational> p = corners<Rational>(p_world);
    const Vector3<Rational> back = exactly<Rational>(view.camera.back);
    const auto depth_of = [&](const Vector3<Rational>& q) {
        return Rational(-dot(back, q - exactly<Rational>(glm::dvec3(view.camera.eye_world))));
    };
    std::vector<Point> shown;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = p[i], &b = p[(i + 1) % 3];
        const Rational at_a = depth_of(a), at_b = depth_of(b);
        if (at_a >= near) shown.push_back(raster_of(ray, a, {0, 0}));
        if ((at_a >= near) != (at_b >= near))
            shown.push_back(raster_of(ray, a + Rational((near - at_a) / (at_b - at_a)) * (b - a), {0, 0}));
    }
    return shown;
}

/// A crowd in an image of several tiles: corners at 1e30 and slivers from tile to tile among them.
struct Wide {
    Rng rng;
    View view;
    int x, y;
    Scene scene;

    explicit Wide(std::uint32_t seed)
        : rng(seed), view(random_view(rng)), x(15 + rng.below(3)), y(31 + rng.below(3)), scene{} {
        view.width = 56, view.height = 40;
        scene = random_crowd(rng, view, x, y);
        auto& p = scene.vertices.position_world;
        glm::vec3& far = p[std::size_t(rng.below(3))];
        if (rng.below(3) == 0) far = glm::vec3(1e30 * glm::normalize(glm::dvec3(far) + glm::dvec3(0x1p-9)));
        if (rng.below(3) == 0) add_sliver();
    }
    /// From one pixel's centre to another's, as thin as may be.
    void add_sliver() {
        const auto first = std::uint32_t(scene.vertices.position_world.size());
        for (const double aside : {0.0, 0x1p-20, -0x1p-20}) {
            const ViewRay<double> ray(view, rng.below(view.width), rng.below(view.height));
            const auto p = ray.origin + 4.0 * ray.direction + aside * ray.step_x;
            scene.vertices.position_world.emplace_back(float(p.x), float(p.y), float(p.z));
        }
        scene.vertices.position_world[first + 2] =
            0.5f * (scene.vertices.position_world[first] + scene.vertices.position_world[first + 1]);
        scene.triangles.emplace_back(first, first + 1, first + 2);
    }
};

void expect_held(const Box& box, const std::vector<Point>& shown) {
    for (const auto& [x, y] : shown) {
        ASSERT_TRUE(box.left == -HUGE_VAL || Rational(box.left) <= x);
        ASSERT_TRUE(box.right == HUGE_VAL || Rational(box.right) >= x);
        ASSERT_TRUE(box.top == -HUGE_VAL || Rational(box.top) <= y);
        ASSERT_TRUE(box.bottom == HUGE_VAL || Rational(box.bottom) >= y);
    }
}

/// What lies nearer than half the near depth counts for a renderer whose near plane may be anywhere.
TEST(TriangleSearch, BoxesHoldWhatTrianglesShow) {
    int shown_ones = 0, bare = 0, bounded = 0, near_ones = 0;
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        const Wide s(seed);
        const ViewBounds of_any_near(s.view, BoundedPrecision{.depth_absolute = 1e30});
        const ViewBounds* const renderers[] = {&of_any_near};
        const TriangleSearch search(s.scene, s.view, {}), near_search(s.scene, s.view, renderers);
        const Rational near(s.view.camera.near_depth), next_to_nothing = near / Rational(1 << 30);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const Box box = search.box_of(t);
            const std::vector<Point> shown = shown_corners(s.view, corners_of(s.scene, t), near);
            expect_held(box, shown);
            if (s.view.camera.projection == Projection::perspective) {
                const auto all_shown = shown_corners(s.view, corners_of(s.scene, t), next_to_nothing);
                expect_held(near_search.box_of(t), all_shown);
                near_ones += all_shown.size() != shown.size();
            }
            if (HasFatalFailure()) FAIL() << t;
            ++(shown.empty() ? bare : shown_ones);
            bounded += !box.is_empty() && box.right - box.left <= 4096 && box.bottom - box.top <= 4096;
        }
    }
    EXPECT_GT(shown_ones, 1000);
    EXPECT_GT(bare, 20);
    EXPECT_GT(near_ones, 20);
    EXPECT_GT(bounded, shown_ones / 2);
}

/// Asks around pixels of several tiles: next to nothing, within a tile, and far beyond the image.
TEST(TriangleSearch, FindsAllThatMeetsWhatATileAsksFor) {
    int near_ones = 0, found_ones = 0, asked_ones = 0;
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        Wide s(seed);
        const Tiles tiles(s.view);
        ASSERT_EQ(tiles.count(), 12u);
        const double reaches[] = {0, 0x1p-9, 0.5, 9, 40, 1e9};
        std::vector<SearchPixel> search_pixels{{s.x, s.y, 0x1p-9, {}}, {16, 31, 0, {}}};
        for (int i = 0; i < 4; ++i)
            search_pixels.push_back({s.rng.below(56), s.rng.below(40), reaches[s.rng.below(6)], {}});
        std::vector<Box> asked(tiles.count());
        for (const SearchPixel& search_pixel : search_pixels)
            asked[tiles.of(search_pixel.x, search_pixel.y)].add(
                square_around(search_pixel.x, search_pixel.y, search_pixel.reach_px));
        const TrianglesByTile found = TriangleSearch(s.scene, s.view, {}).find(asked);
        for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
            ASSERT_TRUE(std::ranges::is_sorted(found.of(tile), std::less_equal{}) ||
                        found.of(tile).size() < 2);
            ASSERT_TRUE(!asked[tile].is_empty() || found.of(tile).empty());
        }
        const ViewBounds bounds(s.view, RasterPrecision{});
        for (const SearchPixel& search_pixel : search_pixels)
            for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
                const SearchPixel only{search_pixel.x, search_pixel.y, search_pixel.reach_px, {t}};
                const bool is_near =
                    comes_near(neighbourhood_of(s.scene, s.view, bounds, only, search_pixel.reach_px),
                               search_pixel.reach_px);
                const bool is_found =
                    std::ranges::count(found.of(tiles.of(search_pixel.x, search_pixel.y)), t) == 1;
                ASSERT_TRUE(is_found || !is_near)
                    << "triangle " << t << " at " << search_pixel.x << ' ' << search_pixel.y;
                ++asked_ones, near_ones += is_near, found_ones += is_found;
            }
    }
    EXPECT_GT(near_ones, asked_ones / 20);
    EXPECT_LT(found_ones, asked_ones * 3 / 4) << "the search rules triangles out";
}

/// A sliver across 10 x 10 tiles comes into those that it passes, not into all of its box.
TEST(TriangleSearch, ASliverComesIntoTheTilesThatItPasses) {
    const View view = pixel_view(Projection::parallel, 160, 160);
    for (const bool rises : {false, true}) {
        const double start = rises ? 160 : 0, end = 160 - start;
        const Scene scene = scene_of(view, {{{{0, start, 4}, {160, end, 4}, {80, 80.001, 4}}}});
        const Tiles tiles(view);
        std::vector<Box> asked;
        for (int row = 0; row < tiles.rows; ++row)
            for (int column = 0; column < tiles.columns; ++column)
                asked.push_back({column * 16.0, row * 16.0, column * 16.0 + 16, row * 16.0 + 16});
        const TrianglesByTile found = TriangleSearch(scene, view, {}).find(asked);
        for (int row = 0; row < tiles.rows; ++row)
            for (int column = 0; column < tiles.columns; ++column) {
                const int away = std::abs((rises ? tiles.rows - 1 - row : row) - column);
                const bool is_found = !found.of(tiles.index(column, row)).empty();
                EXPECT_TRUE(is_found || away > 0) << column << ' ' << row;
                EXPECT_TRUE(!is_found || away < 2) << column << ' ' << row;
            }
    }
}

/// Each side of a triangle parts something that no other does.
TEST(TriangleSearch, RulesOutWhatLiesBeyondOneSide) {
    const View view = pixel_view(Projection::parallel, 64, 64);
    const Scene scene =
        scene_of(view, {{{{8, 8, 4}, {56, 8, 4}, {8, 56, 4}}}, {{{56, 56, 4}, {56, 8, 4}, {8, 56, 4}}}});
    const Tiles tiles(view);
    std::vector<Box> asked(tiles.count());
    asked[tiles.of(50, 50)] = square_around(50, 50, 1);
    asked[tiles.of(12, 12)] = square_around(12, 12, 1);
    const TrianglesByTile found = TriangleSearch(scene, view, {}).find(asked);
    EXPECT_EQ(found.of(tiles.of(50, 50)).size(), 1u);
    EXPECT_EQ(found.of(tiles.of(50, 50))[0], 1u);
    EXPECT_EQ(found.of(tiles.of(12, 12)).size(), 1u);
    EXPECT_EQ(found.of(tiles.of(12, 12))[0], 0u);
}

/// Rounded to float, boxes hold those in double: of places that no float holds well, and far apart.
TEST(TriangleSearch, BoxesAreRoundedOutwards) {
    Rng rng(3);
    const View view = pixel_view(Projection::parallel, 64, 64);
    for (int round = 0; round < 500; ++round) {
        const double scale = std::exp2(rng.between(0, 30));
        const auto place = [&] { return rng.between(-1, 1) * scale; };
        const Scene scene =
            scene_of(view, {{{{place(), place(), 4}, {place(), place(), 4}, {place(), place(), 4}}}});
        const Box box = TriangleSearch(scene, view, {}).box_of(0);
        for (const glm::vec3& p : corners_of(scene, 0)) {
            EXPECT_TRUE(box.left < p.x && p.x < box.right);
            EXPECT_TRUE(box.top < -p.y && -p.y < box.bottom);
        }
        EXPECT_LT(box.right - box.left, 2.001 * scale + 1e-3);
    }
}

}  // namespace
}  // namespace zproof
