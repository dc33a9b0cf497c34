#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drawing.h"
#include "rasterizer/rasterizer.h"

namespace zproof::rasterizer {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float greatest = std::numeric_limits<float>::max();

TEST(OddInput, AnEmptySceneIsAllBackground) {
    const Frame frame = render({}, {.name = "", .camera = {}, .width = 65, .height = 3});
    EXPECT_EQ(frame.size(), (Resolution{65, 3}));
    for (const PrimitiveId id : frame.primitive.pixels()) EXPECT_EQ(id, PrimitiveId::none);
    for (const float depth : frame.camera_depth.pixels()) EXPECT_EQ(depth, background_depth);
}

TEST(OddInput, AnImageOfOnePixel) { EXPECT_EQ(picture({at_pixels(0, 0, 2, 0, 0, 2)}, 1, 1), "\n1\n"); }

TEST(OddInput, TrianglesWithoutAreaCoverNothing) {
    EXPECT_EQ(picture({at_pixels(0, 0, 4, 4, 2, 2), at_pixels(1.5, 1.5, 1.5, 1.5, 1.5, 1.5),
                       at_pixels(0.5, 0.5, 3.5, 0.5, 3.5, 0.5)},
                      4, 4),
              "\n....\n....\n....\n....\n");
}

// The sliver is thinner than half a grid step: snapped, it has no area, though it passes through pixel
// centres.
TEST(OddInput, TrianglesThatSnapToALineCoverNothing) {
    EXPECT_EQ(picture({at_pixels(0, 1.5f, 4, 1.5f, 2, 1.5009f)}, 4, 4), "\n....\n....\n....\n....\n");
}

TEST(OddInput, TrianglesThatAreNotFiniteAreLeftOut) {
    const Triangle good = at_pixels(0, 0, 9, 0, 0, 9);
    for (const float bad : {nan, infinity, -infinity}) {
        for (int k = 0; k < 3; ++k) {
            Triangle broken = at_pixels(0, 0, 9, 0, 0, 9);
            broken[1][k] = bad;
            EXPECT_EQ(ids(render(scene_of({broken, good}), raster_view(2, 2))), "\n11\n11\n");
        }
    }
}

TEST(OddInput, HugeCoordinatesAreDrawn) {
    View view;
    view.width = view.height = 8;
    view.camera.far_depth = std::numeric_limits<double>::infinity();
    for (const float size : {1e30f, greatest}) {
        const Frame frame =
            render(scene_of({{glm::vec3{-size, -size, -2}, {size, -size, -2}, {0, size, -2}}}), view);
        for (const float depth : frame.camera_depth.pixels()) EXPECT_NEAR(depth, 2, 1e-5);
    }
}

TEST(OddInput, NothingDrawnIsEverInvalid) {
    View view;
    view.width = view.height = 16;
    view.camera.near_depth = 1e-6;
    std::mt19937 random(6);
    int covered = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Triangle> triangles = random_triangles(random, 8, glm::dvec3(-1), glm::dvec3(1));
        for (Triangle& t : triangles) {
            for (glm::vec3& p : t) p *= std::pow(10.0f, float(uniform(random, -38, 38)));
        }
        const Frame frame = render(scene_of(triangles), view);
        for (std::size_t i = 0; i < frame.primitive.pixels().size(); ++i) {
            const float depth = frame.camera_depth.pixels()[i];
            if (frame.primitive.pixels()[i] == PrimitiveId::none) {
                ASSERT_EQ(depth, background_depth);
                continue;
            }
            ++covered;
            ASSERT_GE(depth, 0.999e-6f);
            ASSERT_LE(depth, 1000.001f);
        }
    }
    EXPECT_GT(covered, 1000);
}

}  // namespace
}  // namespace zproof::rasterizer
