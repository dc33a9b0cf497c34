#include "oracle/embree.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "oracle/embree_geometry.h"
#include "oracle/oracle_error.h"
#include "oracle/primary_ray.h"
#include "pictures.h"
#include "scenes_at_random.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;

Frame trace(const Corners& corners, const View& view) {
    const Scene scene = scene_of(corners);
    return Embree(scene).trace(view);
}

TEST(Embree, RowsRunDownAndColumnsRunRight) {
    const Corners upper_left{{-2.9f, 1.9f, -1}, {0, 1.9f, -1}, {-2.9f, -0.9f, -1}};
    EXPECT_EQ(picture(trace(upper_left, unit_pixels(6, 4))), R"(
000...
00....
0.....
......
)");
}

TEST(Embree, DepthIsMeasuredAlongTheViewAxisNotAlongTheRay) {
    const Frame frame = trace(wall(4), unit_pixels(6, 4));
    for (const float depth : frame.camera_depth.pixels()) EXPECT_FLOAT_EQ(depth, 4);
}

TEST(Embree, NearestTriangleWinsWithinNearAndFar) {
    const Corners walls = together({wall(5), wall(3), wall(1)});
    View view = unit_pixels(1, 1);
    const auto nearest = [&](double near, double far) {
        view.camera.near_depth = near;
        view.camera.far_depth = far;
        return trace(walls, view);
    };
    constexpr double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(nearest(0.1, 1000).primitive.at(0, 0), PrimitiveId{2});
    EXPECT_EQ(nearest(2, 4).primitive.at(0, 0), PrimitiveId{1});
    EXPECT_EQ(nearest(4, inf).primitive.at(0, 0), PrimitiveId{0});
    EXPECT_EQ(nearest(1.5, 2.5).primitive.at(0, 0), PrimitiveId::none);
    EXPECT_EQ(nearest(1.5, 2.5).camera_depth.at(0, 0), background_depth) << "not the far plane";
    EXPECT_EQ(nearest(6, inf).primitive.at(0, 0), PrimitiveId::none);
}

TEST(Embree, ParallelCameraSeesBehindItsEye) {
    View view = unit_pixels(1, 1);
    view.camera.projection = Projection::parallel;
    view.camera.near_depth = -4;
    view.camera.far_depth = 4;
    const Corners behind{{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}};
    const Frame frame = trace(together({wall(2), behind}), view);
    EXPECT_EQ(frame.primitive.at(0, 0), PrimitiveId{1});
    EXPECT_FLOAT_EQ(frame.camera_depth.at(0, 0), -3);
}

TEST(Embree, BothSidesOfATriangleAreSeen) {
    const Corners front = wall(2), back{front[0], front[2], front[1]};
    EXPECT_EQ(trace(front, unit_pixels(1, 1)).primitive.at(0, 0), PrimitiveId{0});
    EXPECT_EQ(trace(back, unit_pixels(1, 1)).primitive.at(0, 0), PrimitiveId{0});
}

TEST(Embree, EveryPixelOfOddSizesIsTraced) {
    for (int width = 1; width <= 9; ++width) {
        for (int height = 1; height <= 9; ++height) {
            const Frame frame = trace(wall(2), unit_pixels(width, height));
            ASSERT_EQ(frame.size(), (Resolution{width, height}));
            for (const PrimitiveId id : frame.primitive.pixels()) ASSERT_EQ(id, PrimitiveId{0});
        }
    }
}

TEST(Embree, SceneWithoutTrianglesIsBackground) {
    const Frame frame = trace({}, unit_pixels(7, 5));
    EXPECT_TRUE(same_bits(frame, Frame({7, 5})));
}

TEST(Embree, DegenerateTrianglesHideNothing) {
    const glm::vec3 p{0, 0, -1}, q{4, 0, -1}, r{2, 0, -1};
    const Frame frame = trace(together({{p, p, p}, {p, q, q}, {p, q, r}, wall(2)}), unit_pixels(7, 5));
    for (const PrimitiveId id : frame.primitive.pixels()) EXPECT_EQ(id, PrimitiveId{3});
    for (const float depth : frame.camera_depth.pixels()) EXPECT_FLOAT_EQ(depth, 2);
}

TEST(Embree, UnusedLastVertexAndSharedVerticesAreTakenAsTheyStand) {
    Scene scene = scene_of(together({wall(3), {{1, 2, 3}}}));
    scene.triangles = {{2, 1, 0}, {0, 1, 2}, {3, 3, 3}};
    const Frame frame = Embree(scene).trace(unit_pixels(2, 2));
    EXPECT_NE(frame.primitive.at(1, 1), PrimitiveId::none);
    EXPECT_FLOAT_EQ(frame.camera_depth.at(1, 1), 3);
}

/// Embree reads 16 bytes there. Dies in the sanitized build where the padding is missing.
TEST(Embree, LastVertexMayBeReadByASixteenByteLoad) {
    const Positions two(2, glm::vec3(1));
    std::array<std::byte, 16> loaded;
    std::memcpy(loaded.data(), reinterpret_cast<const std::byte*>(two.data()) + 12, loaded.size());
    const float one = 1;
    EXPECT_EQ(std::memcmp(loaded.data(), &one, sizeof one), 0);
}

TEST(Embree, VerticesThatEmbreeWouldDropAreRefusedByNumber) {
    for (const float bad : {1.844e18f, -2e18f, std::numeric_limits<float>::quiet_NaN()}) {
        Corners corners = together({wall(1), wall(2)});
        corners[4].y = bad;
        try {
            trace(corners, unit_pixels(1, 1));
            ADD_FAILURE() << "accepted " << bad;
        } catch (const OracleError& error) {
            EXPECT_THAT(error.what(), HasSubstr("vertex 4 of scene 'soup'"));
        }
    }
}

/// A mesh whose vertices lie half a pixel above the pixel centres, each at a depth of its own from 2 to 4:
/// every view ray runs, as nearly as float32 can, through the middle of an edge.
Scene mesh_with_edges_on_pixel_centres(View view) {
    const double half_a_pixel = (view.camera.window.top - view.camera.window.bottom) / view.height / 2;
    view.camera.window.top += half_a_pixel;
    view.camera.window.bottom += half_a_pixel;
    Rng rng(11);
    Corners vertices;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimaryRay ray = primary_ray(view, x, y);
            vertices.push_back(ray.origin + static_cast<float>(rng.between(2, 4)) * ray.direction);
        }
    }
    Scene scene = scene_of(vertices);
    scene.triangles.clear();
    for (int y = 0; y + 1 < view.height; ++y) {
        for (int x = 0; x + 1 < view.width; ++x) {
            const auto corner = static_cast<unsigned>(y * view.width + x),
                       below = corner + unsigned(view.width);
            scene.triangles.emplace_back(corner, below, corner + 1);
            scene.triangles.emplace_back(below, below + 1, corner + 1);
        }
    }
    return scene;
}

/// Neighbours decide a shared edge alike: that is what Embree's robust flag is for. (Exactly at a vertex it
/// promises nothing: there the signs of the edges around it may be rounded into a hole.)
TEST(Embree, NoRaySlipsThroughAnEdgeThatTwoTrianglesShare) {
    Rng rng(5);
    for (const ProjectionKind projection_kind : {ProjectionKind::perspective, ProjectionKind::off_axis,
                                                 ProjectionKind::orthographic, ProjectionKind::oblique}) {
        View view = random_view(rng, projection_kind);
        view.width = view.height = 200;
        view.camera.near_depth = 1;
        const Scene mesh = mesh_with_edges_on_pixel_centres(view);
        const Frame frame = Embree(mesh).trace(view);
        for (int y = 0; y + 1 < view.height; ++y) {
            for (int x = 1; x + 1 < view.width; ++x) {
                EXPECT_NE(frame.primitive.at(x, y), PrimitiveId::none) << "pixel " << x << ", " << y;
            }
        }
    }
}

/// 15 000 triangles of which each is there three times, exactly: the order in Embree's leaves decides who is
/// seen.
Scene crowded_ties(int triangles = 5'000) {
    Rng rng(7);
    const Scene once = random_soup(rng, Camera{}, triangles);
    const Positions& corners = once.vertices.position_world;
    Corners thrice;
    for (int copy = 0; copy < 3; ++copy) thrice.insert(thrice.end(), corners.begin(), corners.end());
    return scene_of(thrice);
}

Frame on_threads(int threads, const Scene& scene, const View& view) {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return Embree(scene).trace(view); });
}

TEST(Embree, SameBitsForAnyNumberOfThreadsEvenInExactTies) {
    const Scene scene = crowded_ties();
    View view{.name = "ties", .camera = {}, .width = 301, .height = 203};
    view.camera.near_depth = 2;
    const Frame alone = on_threads(1, scene, view);
    EXPECT_TRUE(same_bits(alone, on_threads(1, scene, view)));
    for (const int threads : {2, 3, 8}) {
        EXPECT_TRUE(same_bits(alone, on_threads(threads, scene, view))) << threads << " threads";
    }
}

TEST(Embree, SameBitsForAnyNumberOfThreadsInACompactTree) {
    const Scene scene = crowded_ties(int(compact_from_triangles) / 3 + 1);
    View view{.name = "ties", .camera = {}, .width = 101, .height = 67};
    view.camera.near_depth = 2;
    EXPECT_TRUE(same_bits(on_threads(1, scene, view), on_threads(3, scene, view)));
}

RTCSceneFlags flags_of_a_scene_of(std::size_t triangles) {
    Scene scene = scene_of(wall(3));
    scene.triangles.resize(triangles, scene.triangles.front());
    const DeviceHandle device = new_device();
    return rtcGetSceneFlags(share_triangles(device.get(), scene).get());
}

TEST(Embree, LargeScenesGetACompactTreeAndEverySceneARobustOne) {
    EXPECT_EQ(flags_of_a_scene_of(compact_from_triangles - 1), RTC_SCENE_FLAG_ROBUST);
    EXPECT_EQ(flags_of_a_scene_of(compact_from_triangles), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT);
}

TEST(Embree, ACompactTreeFindsWhatAnotherFinds) {
    const View view{.name = "soup", .camera = {}, .width = 301, .height = 203};
    Rng rng(11);
    const Scene scene = random_soup(rng, view.camera, 5'000);
    Scene large = scene;
    const auto behind = std::uint32_t(large.vertices.position_world.size());
    for (const glm::vec3& corner : {glm::vec3{0, 0, 9}, {1, 0, 9}, {0, 1, 9}})
        large.vertices.position_world.push_back(corner);
    large.triangles.resize(compact_from_triangles, {behind, behind + 1, behind + 2});
    EXPECT_TRUE(same_bits(Embree(scene).trace(view), Embree(large).trace(view)));
}

TEST(Embree, OneBuildServesManyViews) {
    const Scene scene = scene_of(wall(3));
    const Embree first(scene);
    const Frame before = first.trace(unit_pixels(3, 3));
    first.trace(unit_pixels(8, 2));
    EXPECT_TRUE(same_bits(before, first.trace(unit_pixels(3, 3))));
}

TEST(Embree, VersionNamesReleaseAndInstructionSet) {
    EXPECT_THAT(embree_version(),
                testing::MatchesRegex(
                    "Embree (3\\.13|4\\.[0-9]+)\\.[0-9]+ \\((AVX-512|AVX2|AVX|SSE|NEON|NEON2X)\\)"));
}

TEST(Embree, PromisesFloat32Rays) {
    EXPECT_EQ(std::get<RayPrecision>(embree_precision()).arithmetic, Arithmetic::float32);
}

}  // namespace
}  // namespace zproof::oracle
