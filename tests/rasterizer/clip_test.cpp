#include "rasterizer/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "drawing.h"

namespace zproof::rasterizer {
namespace {

constexpr ClipVolume box{.near_depth = 1, .far_depth = 10, .guard_x = 3, .guard_y = 2};

ClipVertex random_vertex(std::mt19937& random) {
    const double depth = uniform(random, -5, 15);
    return {uniform(random, -20, 20), uniform(random, -20, 20), depth, depth};
}

std::set<std::tuple<double, double, double>> corners(const ClipPolygon& polygon) {
    std::set<std::tuple<double, double, double>> set;
    for (const ClipVertex& v : polygon.span()) set.insert({v.x, v.y, v.depth});
    return set;
}

TEST(Clip, OutcodeNamesEverySide) {
    EXPECT_EQ(outcode_of({0, 0, 2, 2}, box), 0);
    EXPECT_EQ(outcode_of({-3, 0, 2, 2}, box), outcode::left);
    EXPECT_EQ(outcode_of({3, 0, 2, 2}, box), outcode::right);
    EXPECT_EQ(outcode_of({0, -3, 2, 2}, box), outcode::bottom);
    EXPECT_EQ(outcode_of({0, 3, 2, 2}, box), outcode::top);
    EXPECT_EQ(outcode_of({0, 0, 0.5, 0.5}, box), outcode::near);
    EXPECT_EQ(outcode_of({0, 0, 11, 11}, box), outcode::far);
    EXPECT_EQ(outcode_of({7, 0, 2, 2}, box), outcode::right | outcode::guard);
    EXPECT_EQ(outcode_of({0, -5, 2, 2}, box), outcode::bottom | outcode::guard);
}

TEST(Clip, WhatIsNotFiniteIsNamedSo) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300}) {
        EXPECT_EQ(outcode_of({bad, 0, 2, 2}, box), outcode::not_finite);
        EXPECT_EQ(outcode_of({0, bad, 2, 2}, box), outcode::not_finite);
        EXPECT_EQ(outcode_of({0, 0, bad, 2}, box), outcode::not_finite);
        EXPECT_EQ(outcode_of({0, 0, 2, bad}, box), outcode::not_finite);
    }
}

TEST(Clip, KeepsATriangleInsideAsItIs) {
    const std::array<ClipVertex, 3> triangle{ClipVertex{0, 0, 2, 2}, {1, 0, 3, 3}, {0, 1, 4, 4}};
    const ClipPolygon polygon = clip(triangle, box);
    ASSERT_EQ(polygon.size, 3);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(polygon.vertices[i].x, triangle[i].x);
        EXPECT_EQ(polygon.vertices[i].depth, triangle[i].depth);
    }
}

TEST(Clip, LeavesNothingOfATriangleBehindTheEye) {
    EXPECT_EQ(clip({ClipVertex{0, 0, -2, -2}, {1, 0, -3, -3}, {0, 1, -4, -4}}, box).size, 0);
}

TEST(Clip, CutsAtTheNearPlaneExactly) {
    const ClipPolygon polygon = clip({ClipVertex{0, 0, 5, 5}, {1, 0, -3, -3}, {0, 1, 5, 5}}, box);
    ASSERT_EQ(polygon.size, 4);
    int on_plane = 0;
    for (const ClipVertex& v : polygon.span()) {
        EXPECT_GE(v.depth, box.near_depth);
        EXPECT_EQ(v.w, v.depth);
        on_plane += v.depth == box.near_depth;
    }
    EXPECT_EQ(on_plane, 2);
}

// Every corner lies inside up to the rounding of coordinates that are below 2^5.
TEST(Clip, LeavesOnlyWhatIsInside) {
    std::mt19937 random(4);
    int cut = 0;
    for (int i = 0; i < 20'000; ++i) {
        const ClipPolygon p =
            clip({random_vertex(random), random_vertex(random), random_vertex(random)}, box);
        cut += p.size > 3;
        for (const ClipVertex& v : p.span()) {
            ASSERT_GE(v.depth, box.near_depth);
            ASSERT_LE(v.depth, box.far_depth);
            ASSERT_LE(std::abs(v.x), box.guard_x * v.w + 0x1p-44);
            ASSERT_LE(std::abs(v.y), box.guard_y * v.w + 0x1p-44);
        }
    }
    EXPECT_GT(cut, 1000);
}

// The neighbours of an edge see it in opposite directions and with different third corners.
TEST(Clip, CutsASharedEdgeToTheSameBits) {
    std::mt19937 random(5);
    int cut_edges = 0;
    for (int i = 0; i < 20'000; ++i) {
        const ClipVertex a = random_vertex(random), b = random_vertex(random);
        // A third corner equal to a reduces the polygon to the edge itself.
        const auto edge = corners(clip({a, b, a}, box));
        if (edge.size() != 2) continue;
        for (const auto& polygon :
             {clip({a, b, random_vertex(random)}, box), clip({b, a, random_vertex(random)}, box)}) {
            const auto all = corners(polygon);
            for (const auto& corner : edge) ASSERT_TRUE(all.contains(corner));
        }
        ++cut_edges;
    }
    EXPECT_GT(cut_edges, 1000);
}

TEST(Clip, AnInfiniteFarPlaneCutsNothing) {
    ClipVolume open = box;
    open.far_depth = std::numeric_limits<double>::infinity();
    const ClipPolygon polygon = clip({ClipVertex{0, 0, 2, 2}, {1, 0, 1e9, 1e9}, {0, 1, 4, 4}}, open);
    EXPECT_EQ(polygon.size, 3);
}

// With 1 - weight for a weight this intersection would be off by 1e-6 of its w.
TEST(Clip, CutsALongEdgeWithoutCancellation) {
    ClipVolume volume{.near_depth = 0.1, .far_depth = 1e12, .guard_x = 1e9, .guard_y = 1e9};
    const ClipPolygon polygon =
        clip({ClipVertex{1e10, 0, 1e10, 1e10}, {-1, 0, -1, -1}, {1e10, 1, 1e10, 1e10}}, volume);
    ASSERT_EQ(polygon.size, 4);
    for (const ClipVertex& v : polygon.span()) EXPECT_NEAR(v.x / v.w, 1, 1e-13);
}

}  // namespace
}  // namespace zproof::rasterizer
