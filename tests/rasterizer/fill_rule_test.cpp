#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing.h"
#include "rasterizer/rasterizer.h"

namespace zproof::rasterizer {
namespace {

TEST(FillRule, EdgeThroughPixelCentresBelongsToTheTriangleOnItsRight) {
    const Triangle left = at_pixels(0.5, 0.5, 2.5, 0.5, 0.5, 4.5);
    EXPECT_EQ(picture({left}, 4, 5), R"(
11..
11..
1...
1...
....
)");
}

TEST(FillRule, TheSameEdgesSeenFromTheOtherSideOwnWhatIsLeft) {
    const Triangle right = at_pixels(2.5, 0.5, 2.5, 4.5, 0.5, 4.5);
    EXPECT_EQ(picture({right}, 4, 5), R"(
....
....
.1..
.1..
....
)");
}

TEST(FillRule, LevelEdgeThroughPixelCentresBelongsToTheTriangleBelow) {
    const Triangle above = at_pixels(0, 2.5, 4, 2.5, 2, 0);
    const Triangle below = at_pixels(0, 2.5, 4, 2.5, 2, 5);
    EXPECT_EQ(picture({above}, 4, 5), R"(
....
.11.
....
....
....
)");
    EXPECT_EQ(picture({below}, 4, 5), R"(
....
....
1111
.11.
....
)");
}

TEST(FillRule, SinglePixelIsCoveredByItsCentreOnly) {
    EXPECT_EQ(picture({at_pixels(1.25, 1.25, 1.75, 1.25, 1.5, 1.75)}, 3, 3), "\n...\n.1.\n...\n");
    EXPECT_EQ(picture({at_pixels(1.0, 1, 1.49f, 1, 1, 1.49f)}, 3, 3), "\n...\n...\n...\n");
}

std::vector<Triangle> fan_of_square(float side, glm::vec2 hub) {
    return {at_pixels(0, 0, side, 0, hub.x, hub.y), at_pixels(side, 0, side, side, hub.x, hub.y),
            at_pixels(side, side, 0, side, hub.x, hub.y), at_pixels(0, side, 0, 0, hub.x, hub.y)};
}

// Half of the hubs lie on a pixel centre: there only the fill rule decides.
TEST(FillRule, FanAroundAnySharedVertexHasNoHoleAndNoOverlap) {
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        glm::vec2 hub{uniform(random, 0, 8), uniform(random, 0, 8)};
        if (seed % 2) hub = glm::floor(hub) + 0.5f;
        ASSERT_EQ(picture(fan_of_square(8, hub), 8, 8), all_ones(8, 8));
    }
}

// Grid points on quarters of a pixel put many samples exactly on edges.
TEST(FillRule, JitteredMeshHasNoHoleAndNoOverlap) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        glm::vec2 point[5][5];
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 5; ++i) {
                const auto jitter = [&](int k) {
                    return k % 4 ? std::round(float(uniform(random, -3, 3))) / 4 : 0.0f;
                };
                point[j][i] = {4 * float(i) + jitter(i), 4 * float(j) + jitter(j)};
            }
        }
        std::vector<Triangle> mesh;
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                const auto a = point[j][i], b = point[j][i + 1], c = point[j + 1][i], d = point[j + 1][i + 1];
                mesh.push_back(at_pixels(a.x, a.y, b.x, b.y, c.x, c.y));
                mesh.push_back(at_pixels(b.x, b.y, d.x, d.y, c.x, c.y));
            }
        }
        ASSERT_EQ(picture(mesh, 16, 16), all_ones(16, 16));
    }
}

TEST(FillRule, WindingDoesNotMatter) {
    std::mt19937 random(7);
    for (const Triangle& t : random_triangles(random, 200, {-4, -20, -2}, {20, 4, -1})) {
        const Triangle turned = {t[0], t[2], t[1]};
        ASSERT_EQ(picture({t}, 16, 16), picture({turned}, 16, 16));
    }
}

TEST(FillRule, FirstVertexDoesNotMatter) {
    std::mt19937 random(8);
    for (const Triangle& t : random_triangles(random, 200, {-4, -20, -2}, {20, 4, -1})) {
        const Triangle turned = {t[1], t[2], t[0]};
        ASSERT_EQ(picture({t}, 16, 16), picture({turned}, 16, 16));
    }
}

// Whole pixels: the picture moves along and nothing else happens.
TEST(FillRule, WholePixelTranslationMovesThePicture) {
    std::mt19937 random(9);
    for (const Triangle& t : random_triangles(random, 200, {0, -12, -2}, {12, 0, -1})) {
        Triangle snapped = t;
        for (auto& p : snapped) p = {std::round(p.x * 256) / 256, std::round(p.y * 256) / 256, -1};
        Triangle moved = snapped;
        for (auto& p : moved) p += glm::vec3{3, -2, 0};
        const Frame here = render(scene_of({snapped}), raster_view(16, 16));
        const Frame there = render(scene_of({moved}), raster_view(16, 16));
        for (int y = 0; y < 14; ++y) {
            for (int x = 0; x < 13; ++x) ASSERT_EQ(here.primitive.at(x, y), there.primitive.at(x + 3, y + 2));
        }
    }
}

// The split point lies on the grid and on the edge, so that the halves cover exactly what the whole does.
TEST(FillRule, SplitTriangleCoversTheSamePixels) {
    std::mt19937 random(10);
    for (const Triangle& t : random_triangles(random, 200, {0, -16, -2}, {16, 0, -1})) {
        Triangle whole = t;
        for (auto& p : whole) p = {std::round(p.x * 128) / 128, std::round(p.y * 128) / 128, -1};
        const glm::vec3 middle = 0.5f * (whole[0] + whole[1]);
        const Triangle first = {whole[0], middle, whole[2]}, second = {middle, whole[1], whole[2]};
        ASSERT_EQ(picture({first, second}, 16, 16), picture({whole}, 16, 16));
    }
}

}  // namespace
}  // namespace zproof::rasterizer
