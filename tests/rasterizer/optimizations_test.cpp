/// The optimizations save work and change nothing; what they save is counted, the same for any number of
/// threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>

#include "drawing.h"
#include "math/processor.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/shader.h"
#include "scenes/suite.h"

namespace zproof::rasterizer {
namespace {

constexpr Optimizations plain{.hierarchical_z = HierarchicalZ::none};

/// Every view of some suite scenes, small.
template <class Check>
void on_suite(Check check) {
    for (const char* name : {"near_plane", "guard_band", "deep_overdraw", "coplanar", "closed_surfaces",
                             "depth_range", "off_axis", "oblique", "degenerate"}) {
        const Loaded loaded = generate_suite_scene(name, 150, 84);
        for (const View& view : loaded.views) {
            SCOPED_TRACE(std::string{name} + " / " + view.name);
            check(loaded.scene, view);
        }
    }
}

Frame drawn(const Scene& scene, const View& view, const Optimizations& optimizations) {
    Pipeline pipeline(correct_rules, widest_of(kernels), optimizations);
    pipeline.render(scene, view, chunks_of(scene));
    return pipeline.take_frame();
}

Work counted(const Scene& scene, const View& view, const Optimizations& optimizations) {
    return Pipeline(correct_rules, widest_of(kernels), optimizations)
        .count_work(scene, view, chunks_of(scene));
}

TEST(Optimizations, HierarchicalZAndFrustumCullingKeepEveryBit) {
    on_suite([](const Scene& scene, const View& view) {
        const Frame expected = render(scene, view);
        EXPECT_TRUE(same_bits(expected, drawn(scene, view, plain)));
        Optimizations culled = plain;
        culled.frustum_culling = FrustumCulling::chunks;
        EXPECT_TRUE(same_bits(expected, drawn(scene, view, culled)));
        culled.hierarchical_z = HierarchicalZ::blocks;
        EXPECT_TRUE(same_bits(expected, drawn(scene, view, culled)));
    });
}

TEST(Optimizations, NearestFirstKeepsEveryBitAndWritesLess) {
    on_suite([](const Scene& scene, const View& view) {
        const Frame expected = drawn(scene, view, {.order = DrawOrder::as_stored});
        EXPECT_TRUE(same_bits(expected, drawn(scene, view, {.order = DrawOrder::front_to_back})));
        EXPECT_TRUE(same_bits(expected, drawn(scene, view, {})));
    });
    const Loaded deep = generate_suite_scene("deep_overdraw", 960, 540);
    const View& view = deep.views.front();
    const Tally stored = counted(deep.scene, view, {.order = DrawOrder::as_stored}).tally;
    const Tally nearest = counted(deep.scene, view, {.order = DrawOrder::front_to_back}).tally;
    EXPECT_LT(nearest.fragments, stored.fragments / 2);
    EXPECT_LT(nearest.written, stored.written);
}

TEST(Optimizations, NearestFirstIsForWhatLiesDeep) {
    const auto tally_of = [](const char* name) {
        const Loaded loaded = generate_suite_scene(name, 960, 540);
        return counted(loaded.scene, loaded.views.front(), {.order = DrawOrder::as_stored}).bins;
    };
    EXPECT_TRUE(front_to_back_pays(tally_of("deep_overdraw")));
    EXPECT_TRUE(front_to_back_pays(tally_of("room")));
    EXPECT_FALSE(front_to_back_pays(tally_of("shared_edges"))) << "nothing lies over anything";
    EXPECT_FALSE(front_to_back_pays(tally_of("closed_surfaces"))) << "small triangles";
}

TEST(Optimizations, ReachedIsWhatTilesHaveOfTheImage) {
    const Triangle first = at_pixels(1, 1, 1, 7, 7, 1), second = at_pixels(65, 1, 65, 7, 70, 1);
    const auto reached_px = [](const std::vector<Triangle>& triangles) {
        return counted(scene_of(triangles), raster_view(100, 40), {}).bins.reached_px;
    };
    EXPECT_EQ(reached_px({first}), 64u * 40u);
    EXPECT_EQ(reached_px({second, second}), 36u * 40u);
    EXPECT_EQ(reached_px({first, second}), 100u * 40u);
}

TEST(Optimizations, CoverIsAnAreaOrWhatTheImageHasOfItsBox) {
    const auto cover_px = [](const std::vector<Triangle>& triangles) {
        return counted(scene_of(triangles), raster_view(16, 12), {}).bins.cover_px;
    };
    const Triangle half = at_pixels(1, 1, 1, 7, 7, 1), beyond = at_pixels(-16, -16, 64, -16, -16, 64);
    EXPECT_EQ(cover_px({half}), 18u);
    EXPECT_EQ(cover_px({beyond}), 16u * 12u);
    EXPECT_EQ(cover_px({half, beyond, at_pixels(20, 1, 20, 7, 30, 1)}), 18u + 16u * 12u)
        << "the last is outside";
}

TEST(Optimizations, FrontToBackKeepsEveryDepthAndChangesIdsInTiesOnly) {
    on_suite([](const Scene& scene, const View& view) {
        const Frame expected = render(scene, view);
        const Frame sorted = drawn(scene, view, {.order = DrawOrder::chunks_front_to_back});
        EXPECT_TRUE(std::ranges::equal(expected.camera_depth.pixels(), sorted.camera_depth.pixels()));
    });
}

TEST(Optimizations, AFrontIsCounterClockwise) {
    const Triangle counter = at_pixels(1, 1, 1, 7, 7, 1), clockwise = at_pixels(1, 9, 7, 9, 1, 15);
    const Scene scene = scene_of({counter, clockwise});
    const Frame frame = drawn(scene, raster_view(16, 16), {.facing = Facing::front});
    EXPECT_EQ(frame.primitive.at(2, 2), PrimitiveId{0});
    EXPECT_EQ(frame.primitive.at(2, 10), PrimitiveId::none);
    const Work work = counted(scene, raster_view(16, 16), {.facing = Facing::front});
    EXPECT_EQ(work.bins.set_up, 1u);
    EXPECT_EQ(work.bins.facing_away, 1u);
}

TEST(Optimizations, ChunksHoldEveryTriangleOnceAndTheirBoxesHoldThem) {
    on_suite([](const Scene& scene, const View&) {
        std::uint32_t next = 0;
        for (const Chunk& chunk : chunks_of(scene)) {
            EXPECT_EQ(chunk.triangles.begin, next);
            EXPECT_LE(chunk.triangles.end - chunk.triangles.begin, 1024u);
            next = chunk.triangles.end;
            for (std::uint32_t t = chunk.triangles.begin; t < next; ++t)
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t v = scene.triangles[t][k];
                    EXPECT_TRUE(v >= chunk.vertices.begin && v < chunk.vertices.end);
                    const glm::vec3 p = scene.vertices.position_world[v];
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(chunk.low, p)) || !chunk.is_finite);
                }
        }
        EXPECT_EQ(next, scene.triangles.size());
    });
}

TEST(Optimizations, WhatLiesBesideTheWindowIsNotTransformed) {
    const Loaded loaded = generate_suite_scene("closed_surfaces", 64, 36);
    View view = loaded.views.front();
    const double width = view.camera.window.right - view.camera.window.left;
    view.camera.window.left += 0.9 * width;  // a tenth of the picture
    view.camera.near_depth = 1e-3;
    const Work all = counted(loaded.scene, view, plain);
    const Work some = counted(loaded.scene, view, {.frustum_culling = FrustumCulling::chunks});
    EXPECT_GT(some.chunks_culled, 0u);
    EXPECT_LT(some.vertices, all.vertices);
    EXPECT_EQ(some.seen, all.seen);
    EXPECT_EQ(some.bins.set_up, all.bins.set_up);
}

TEST(Optimizations, CountsAreWhatTheyAreCalled) {
    on_suite([](const Scene& scene, const View& view) {
        const Work work = counted(scene, view, plain),
                   hierarchical = counted(scene, view, {.order = DrawOrder::as_stored});
        const Plane<std::uint32_t> fragments = count_fragments(correct_rules, scene, view);
        const std::uint64_t sum =
            std::accumulate(fragments.pixels().begin(), fragments.pixels().end(), std::uint64_t{0});
        EXPECT_EQ(work.tally.fragments, sum);
        EXPECT_EQ(work.tally.hidden_blocks, 0u);
        EXPECT_EQ(work.tally.written, hierarchical.tally.written);
        EXPECT_EQ(work.tally.blocks >= hierarchical.tally.blocks - hierarchical.tally.hidden_blocks, true);
        EXPECT_LE(hierarchical.tally.fragments, work.tally.fragments);
        EXPECT_EQ(work.vertices, scene.vertices.position_world.size());
        EXPECT_EQ(work.bins.triangles, scene.triangles.size());
        EXPECT_LE(work.seen, work.tally.written);
    });
}

bool same_work(const Work& a, const Work& b) {
    return a.vertices == b.vertices && a.bins.set_up == b.bins.set_up && a.entries == b.entries &&
           a.bins.cut == b.bins.cut && a.bins.outside == b.bins.outside && a.seen == b.seen &&
           a.tally.blocks == b.tally.blocks && a.tally.hidden_blocks == b.tally.hidden_blocks &&
           a.tally.fragments == b.tally.fragments && a.tally.written == b.tally.written;
}

TEST(Optimizations, CountsAreTheSameForAnyNumberOfThreadsAndEveryInstructionSet) {
    const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 4);
    const Loaded loaded = generate_suite_scene("deep_overdraw", 200, 150);
    const Work expected = counted(loaded.scene, loaded.views.front(), {});
    EXPECT_GT(expected.tally.hidden_blocks, 0u);
    for (const Kernel& kernel : available_of(kernels))
        for (const int threads : {1, 2, 4}) {
            tbb::task_arena arena(threads);
            arena.execute([&] {
                Pipeline pipeline(correct_rules, kernel);
                EXPECT_TRUE(same_work(expected, pipeline.count_work(loaded.scene, loaded.views.front())))
                    << kernel.name << " on " << threads;
            });
        }
}

TEST(Optimizations, EarlyAndLateShadingGiveThePictureOfTheDeferredOne) {
    on_suite([](const Scene& scene, const View& view) {
        const Light light;
        const Picture deferred = shade(scene, view, render(scene, view), light);
        const Work work = counted(scene, view, plain);
        Pipeline pipeline(correct_rules, widest_of(kernels), plain);
        for (const ShadingTime time : {ShadingTime::before_the_test, ShadingTime::after_the_test}) {
            const ShadedFrame frame = pipeline.render_shaded(scene, view, light, time);
            EXPECT_TRUE(std::ranges::equal(deferred.pixels(), frame.picture.pixels()));
            EXPECT_EQ(frame.shaded,
                      time == ShadingTime::before_the_test ? work.tally.fragments : work.tally.written);
        }
    });
}

}  // namespace
}  // namespace zproof::rasterizer
