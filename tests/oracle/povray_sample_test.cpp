// What POV-Ray is asked about where nobody asks for every pixel, and what it is not shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "oracle/oracle_error.h"
#include "oracle/povray.h"
#include "oracle/povray/budget.h"
#include "oracle/povray/geometry.h"
#include "oracle/povray/raster_box.h"
#include "scenes/suite.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;

constexpr std::array all_kinds{ProjectionKind::perspective, ProjectionKind::off_axis,
                               ProjectionKind::orthographic, ProjectionKind::oblique};

/// From the eye, in the world's axes: where the ray of a pixel's centre is at this depth.
glm::dvec3 on_ray(const View& view, int x, int y, double depth) {
    const Camera& c = view.camera;
    const glm::dvec2 centre{c.window.left + (c.window.right - c.window.left) * (x + 0.5) / view.width,
                            c.window.top - (c.window.top - c.window.bottom) * (y + 0.5) / view.height};
    const glm::dvec2 across =
        c.projection == Projection::perspective ? depth * centre : centre + depth * c.shear;
    return across.x * c.right + across.y * c.up - depth * c.back;
}

TEST(RasterBox, CountsTheCentreOfEveryRayThatMeetsATriangle) {
    Rng rng(11);
    for (int round = 0; round < 4000; ++round) {
        View view = random_view(rng, all_kinds[std::size_t(round % 4)]);
        view.width = 1 + int(rng.between(0, 40)), view.height = 1 + int(rng.between(0, 40));
        const int x = int(rng.between(0, view.width)), y = int(rng.between(0, view.height));
        const glm::dvec3 met = on_ray(view, x, y, rng.between(2, 9));
        // the middle of a triangle, of any size, some of whose corners may lie behind the eye
        const double size = std::pow(10, rng.between(-7, 2));
        const auto step = [&] {
            return size * glm::dvec3{rng.between(-1, 1), rng.between(-1, 1), rng.between(-1, 1)};
        };
        const glm::dvec3 first = step(), second = step();
        const std::array corners{met + first, met + second, met - (first + second)};
        const View one = view_of({.stride = 64, .first_x = x, .first_y = y}, view);
        ASSERT_EQ(one.width * one.height, 1);
        EXPECT_EQ(centres_around(corners, one, 1), 1u);
        EXPECT_GE(centres_around(corners, view, 1), 1u);
    }
}

TEST(RasterBox, CountsNoneForWhatLiesBetweenCentresOrOutside) {
    const View view{.name = "v", .camera = {}, .width = 8, .height = 8};  // window -1 ... 1, pixels of 1/4
    const auto box = [&](double left, double right) {
        return centres_around(std::array<glm::dvec3, 2>{{{left, -0.01, -1}, {right, 0.2, -1}}}, view, 1);
    };
    EXPECT_EQ(box(0.14, 0.36), 0u);  // between the centres at 0.125 and 0.375
    EXPECT_EQ(box(0.12, 0.36), 1u);
    EXPECT_EQ(box(0.12, 0.38), 2u);
    EXPECT_EQ(box(1.01, 9), 0u);  // beyond the right side
    EXPECT_EQ(box(-9, 9), 8u);    // one whole row
    const std::array<glm::dvec3, 2> around_the_eye{{{0.14, 0.14, -1}, {0.15, 0.15, 1}}};
    EXPECT_EQ(centres_around(around_the_eye, view, 1), 64u);
}

TEST(PovRaySample, NamesWhatTheWholePictureNamesThere) {
    for (const char* name : {"room", "orthographic", "oblique", "near_plane"}) {
        const Loaded suite = generate_suite_scene(name, 96, 54);
        for (const View& view : suite.views) {
            const PixelLattice lattice{.stride = 5, .first_x = 3, .first_y = 1};
            const PovRay povray(suite.scene);
            const auto sample = povray.begin(view_of(lattice, view), 1);
            const Frame whole = frame_at(lattice, povray.render(view)), some = sample();
            EXPECT_TRUE(std::ranges::equal(whole.primitive.pixels(), some.primitive.pixels()))
                << name << "/" << view.name;
            for (std::size_t i = 0; i < some.camera_depth.pixels().size(); ++i)
                if (some.primitive.pixels()[i] != PrimitiveId::none) {
                    EXPECT_NEAR(some.camera_depth.pixels()[i] / whole.camera_depth.pixels()[i], 1, 0x1p-22);
                }
        }
    }
}

TEST(PovRaySample, TrianglesThatNoRayMeetsAreNotWritten) {
    const Loaded suite = generate_suite_scene("closed_surfaces", 1920, 1080);
    const View& view = suite.views.at(0);
    const auto written = [&](int stride) {
        std::size_t count = 0;
        for (const PovrayCluster& cluster :
             povray_geometry(suite.scene, view_of({.stride = stride}, view)).clusters)
            count += cluster.triangles.size();
        return count;
    };
    EXPECT_LT(written(24), written(6));
    EXPECT_LT(written(6), suite.scene.triangles.size());
}

TEST(PovRayBudget, IsAKnownNumberOfPixelsDrawnByTheSeed) {
    const Loaded suite = generate_suite_scene("room", 1920, 1080);
    const auto [lattice, fewer_because, seconds] = affordable_pixels(suite.scene, suite.views.at(0), 1);
    EXPECT_EQ(lattice.stride, 6);
    EXPECT_EQ(size_of(lattice, {1920, 1080}).pixel_count(), 57'600u);
    EXPECT_EQ(fewer_because, "");
    const auto again = affordable_pixels(suite.scene, suite.views.at(0), 1).lattice;
    EXPECT_EQ((std::pair{again.first_x, again.first_y}), (std::pair{lattice.first_x, lattice.first_y}));
    std::set<std::pair<int, int>> firsts;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto drawn = affordable_pixels(suite.scene, suite.views.at(0), seed).lattice;
        firsts.insert({drawn.first_x, drawn.first_y});
    }
    EXPECT_EQ(firsts.size(), 36u);  // every pixel of the image may be asked about
}

TEST(PovRayBudget, AsksAboutEveryPixelOfASmallPicture) {
    const Loaded suite = generate_suite_scene("room", 64, 36);
    EXPECT_EQ(affordable_pixels(suite.scene, suite.views.at(0), 1).lattice.stride, 1);
}

TEST(PovRayBudget, SlowScenesHaveASmallerShareAndAReason) {
    const Loaded slivers = generate_suite_scene("slivers", 1920, 1080);
    const AffordablePixels few = affordable_pixels(slivers.scene, slivers.views.at(0), 1);
    EXPECT_GT(few.lattice.stride, 6);
    EXPECT_THAT(few.fewer_because, HasSubstr("boxes of triangles"));
    const Loaded many = generate_suite_scene("closed_surfaces", 1920, 1080);
    EXPECT_THAT(affordable_pixels(many.scene, many.views.at(0), 1).fewer_because,
                HasSubstr("triangles are many to read"));
}

TEST(PovRayBudget, WhatNoPixelCanPayIsRefusedWithAReason) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 140'000; ++i) {
        const float z = -2 - float(i) * 1e-5f;
        corners.insert(corners.end(), {{-9, -9, z}, {9, -9, z}, {0, 18, z}});
    }
    const Scene scene = scene_of(corners);
    View view{.name = "v", .camera = {}, .width = 64, .height = 36};
    try {
        affordable_pixels(scene, view, 1);
        FAIL() << "140,000 triangles in front of each other were found cheap";
    } catch (const OracleError& e) {
        EXPECT_THAT(e.what(), HasSubstr("even for one pixel; --oracle povray asks about all"));
    }
}

}  // namespace
}  // namespace zproof::oracle
