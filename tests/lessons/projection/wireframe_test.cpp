// The wireframe, and its distance from pictures.
#include <gtest/gtest.h>

#include <algorithm>

#include "lessons/projection/edge_distance.h"
#include "lessons/projection/wireframe.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::study::projection {
namespace {

Scene scene_of(const std::vector<glm::vec3>& corners, const Bulk<glm::uvec3>& triangles) {
    Scene scene;
    scene.name = "test";
    scene.vertices.position_world.assign(corners.begin(), corners.end());
    scene.triangles = triangles;
    scene.materials.resize(1);
    scene.parts = {{"n", "m", 0, 0, std::uint32_t(triangles.size()), 0}};
    return scene;
}

/// Two triangles of a square that share a diagonal, with a vertex of its own at one shared corner.
Scene square(float z) {
    return scene_of({{-0.5f, -0.5f, z}, {0.5f, -0.5f, z}, {0.5f, 0.5f, z}, {-0.5f, 0.5f, z}, {0.5f, 0.5f, z}},
                    {{0, 1, 2}, {0, 4, 3}});
}

View view_of_square() {
    View view{.name = "front", .camera = {}};
    view.width = 64, view.height = 48;
    return view;
}

TEST(Edges, AreFoundOnceWhereverTheirCornersAreStored) {
    const auto edges = edges_of(square(-1));
    ASSERT_EQ(edges.size(), 5u);
    EXPECT_EQ(std::ranges::count_if(edges, [](const SceneEdge& e) { return e.triangles.size() == 2; }), 1);
}

TEST(Edges, OfNoLengthAreLeftOut) {
    EXPECT_EQ(edges_of(scene_of({{0, 0, -1}, {1, 0, -1}, {0, 0, -1}}, {{0, 1, 2}})).size(), 1u);
}

TEST(Lines, StandWhereTheCornersAreSeen) {
    const Wireframe w = wireframe_of(square(-1), view_of_square());
    ASSERT_EQ(w.lines.size(), 5u);
    // x = -0.5 of [-1, 1] is a quarter of 64 px; y likewise of 48
    EXPECT_TRUE(std::ranges::any_of(w.lines, [](const WireLine& line) {
        return glm::length(line.segment.a - glm::dvec2{16, 36}) < 1e-9 &&
               glm::length(line.segment.b - glm::dvec2{48, 36}) < 1e-9;
    }));
}

TEST(Lines, AreCutByNearFarAndThePicture) {
    View view = view_of_square();
    const Scene through = scene_of({{0, -0.02f, 1}, {0, -0.02f, -1}, {9, -0.02f, -1}}, {{0, 1, 2}});
    for (const WireLine& line : wireframe_of(through, view).lines)
        for (const glm::dvec2& p : {line.segment.a, line.segment.b}) {
            EXPECT_GE(p.x, 0);
            EXPECT_LE(p.x, 64);
            EXPECT_GE(p.y, 0);
            EXPECT_LE(p.y, 48);
        }
    // The first edge runs from near (depth 0.1: y = -0.2) to depth 1 (y = -0.02).
    const Outliner outliner{through, view};
    const auto first = outliner.line({0, -0.02f, 1}, {0, -0.02f, -1});
    ASSERT_TRUE(first);
    EXPECT_NEAR(first->a.y, 24 * 1.2, 1e-5);
    EXPECT_NEAR(first->b.y, 24 * 1.02, 1e-5);
    view.camera.near_depth = 2;
    EXPECT_TRUE(wireframe_of(through, view).lines.empty());
}

TEST(Lines, BehindAnotherSurfaceAreHidden) {
    Scene scene = square(-2);  // behind, smaller in the picture
    const Scene before = square(-1);
    for (const glm::vec3& p : before.vertices.position_world) scene.vertices.position_world.push_back(p);
    scene.triangles.push_back({5, 6, 7}), scene.triangles.push_back({5, 9, 8});
    scene.parts[0].triangle_count = 4;
    const Wireframe w = wireframe_of(scene, view_of_square());
    const Wireframe told = split_by_visibility(w, rasterizer::render(scene, view_of_square()).primitive);
    for (const WireLine& line : told.lines) {
        const bool is_behind = told.edges[line.edge].triangles.front() < 2;
        EXPECT_EQ(line.visibility, is_behind ? Visibility::hidden : Visibility::seen);
    }
}

TEST(SegmentDistance, OfCrossingOnesIsZero) {
    EXPECT_EQ(distance_between({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}), 0);
    EXPECT_DOUBLE_EQ(distance_between({{0, 0}, {2, 0}}, {{1, 3}, {1, 0.5}}), 0.5);
    EXPECT_DOUBLE_EQ(distance_between({{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}), 1);
}

TEST(EdgeAgreement, OfOurRasterizerIsWithinItsSnapping) {
    for (const char* name : {"textured_ground", "slivers", "oblique"}) {
        SCOPED_TRACE(name);
        const Loaded loaded = generate_suite_scene(name, 240, 135);
        for (const View& view : loaded.views) {
            const Frame frame = rasterizer::render(loaded.scene, view);
            const EdgeAgreement a =
                edge_agreement(loaded.scene, view, frame.primitive, rasterizer::precision());
            EXPECT_GT(a.boundaries, 100u);
            EXPECT_EQ(a.beyond, 0u) << view.name << ": " << a.farthest.x << " " << a.farthest.y << " "
                                    << a.largest_px;
            EXPECT_LE(a.largest_share, 1);
            EXPECT_EQ(a.crossed + a.displaced + a.by_depth + a.by_others + a.beyond, a.boundaries);
        }
    }
}

TEST(EdgeAgreement, APictureThatIsShiftedIsFarFromItsWireframe) {
    const Scene scene = square(-1);
    Plane<PrimitiveId> ids = rasterizer::render(scene, view_of_square()).primitive;
    Plane<PrimitiveId> shifted{ids.size(), PrimitiveId::none};
    for (int y = 0; y < 48; ++y)
        for (int x = 2; x < 64; ++x) shifted.at(x, y) = ids.at(x - 2, y);
    const EdgeAgreement a = edge_agreement(scene, view_of_square(), shifted, rasterizer::precision());
    EXPECT_GT(a.beyond, 20u);
    EXPECT_GT(a.largest_px, 1);
    EXPECT_LT(a.largest_px, 2.1);
}

TEST(EdgeAgreement, SurfacesThatCrossHaveNoEdgeThere) {
    // One square leans into another along x = 0.
    const Scene scene = scene_of({{-0.6f, -0.5f, -1},
                                  {0.6f, -0.5f, -1},
                                  {0, 0.7f, -1},
                                  {-0.6f, -0.5f, -1.3f},
                                  {0.6f, -0.5f, -0.7f},
                                  {0, 0.7f, -1}},
                                 {{0, 1, 2}, {3, 4, 5}});
    const EdgeAgreement a =
        edge_agreement(scene, view_of_square(), rasterizer::render(scene, view_of_square()).primitive,
                       rasterizer::precision());
    EXPECT_GT(a.by_depth, 10u);
    EXPECT_EQ(a.beyond, 0u);
}

}  // namespace
}  // namespace zproof::study::projection
