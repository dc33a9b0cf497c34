#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "drawing.h"
#include "rasterizer/rasterizer.h"

namespace zproof::rasterizer {
namespace {

constexpr std::uint32_t crowd_size = 6000;

/// Enough triangles for several runs of the binning, over several tiles. All are drawn a second time after
/// the last, in other runs, so that ties show whether the order is kept.
Scene crowd() {
    std::mt19937 random(12);
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < crowd_size; ++i) {
        const glm::dvec3 middle{uniform(random, -4, 4), uniform(random, -3, 3), uniform(random, -9, 1)};
        triangles.push_back(random_triangles(random, 1, middle - 0.3, middle + 0.3).front());
    }
    for (std::uint32_t i = 0; i < crowd_size; ++i) triangles.push_back(triangles[i]);
    return scene_of(triangles);
}

Frame render_on(int threads, const Scene& scene, const View& view) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return render(scene, view); });
}

TEST(Determinism, AnyNumberOfThreadsAndAnyRunGivesTheSameBits) {
    const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 4);
    const Scene scene = crowd();
    const View view{.name = "crowd", .camera = {}, .width = 333, .height = 222};
    const Frame alone = render_on(1, scene, view);
    for (const int threads : {1, 2, 4}) {
        for (int run = 0; run < 3; ++run) {
            ASSERT_TRUE(same_bits(alone, render_on(threads, scene, view)))
                << threads << " threads, run " << run;
        }
    }
}

TEST(Determinism, TiesKeepSceneOrderAcrossRunsOfTheBinning) {
    const Frame frame = render_on(2, crowd(), {.name = "crowd", .camera = {}, .width = 333, .height = 222});
    int covered = 0;
    for (const PrimitiveId id : frame.primitive.pixels()) {
        if (id == PrimitiveId::none) continue;
        ++covered;
        ASSERT_LT(static_cast<std::uint32_t>(id), crowd_size) << "the later copy of a triangle won";
    }
    EXPECT_GT(covered, 333 * 222 / 4);
}

/// The triangles from `first` on by themselves, drawn over what was drawn of those before: nearer wins.
void draw_over(Frame& frame, const Scene& scene, std::uint32_t first, const View& view) {
    Scene part = scene;
    part.triangles.assign(scene.triangles.begin() + first, scene.triangles.begin() + first + 1000);
    const Frame drawn = render(part, view);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (!(drawn.camera_depth.at(x, y) < frame.camera_depth.at(x, y))) continue;
            frame.camera_depth.at(x, y) = drawn.camera_depth.at(x, y);
            frame.primitive.at(x, y) = PrimitiveId{first + std::uint32_t(drawn.primitive.at(x, y))};
        }
}

// Nor are the runs, each with pieces of large triangles that the near plane cuts: a thousand triangles are
// one run.
TEST(Determinism, RunsOfTheBinningDoNotShow) {
    std::mt19937 random(14);
    const Scene scene = scene_of(random_triangles(random, crowd_size, {-30, -20, -60}, {30, 20, 10}));
    const View view{.name = "cut", .camera = {}, .width = 333, .height = 222};
    const Frame whole = render(scene, view);
    Frame parts(whole.size());
    for (std::uint32_t first = 0; first < crowd_size; first += 1000) draw_over(parts, scene, first, view);
    int other_ids = 0;
    for (std::size_t i = 0; i < whole.primitive.pixels().size(); ++i) {
        ASSERT_EQ(whole.camera_depth.pixels()[i], parts.camera_depth.pixels()[i]) << "pixel " << i;
        other_ids += whole.primitive.pixels()[i] != parts.primitive.pixels()[i] ? 1 : 0;
    }
    EXPECT_EQ(other_ids, 0);
}

// The tiles are no part of the answer: a view is the same whichever image it is cut from.
TEST(Determinism, TileBordersDoNotShow) {
    std::mt19937 random(13);
    const Scene scene = scene_of(random_triangles(random, 60, {-20, -212, -50}, {212, 20, -1}));
    const Frame whole = render(scene, raster_view(192, 192));
    for (const int cut : {1, 37, 63, 64, 65}) {
        View part = raster_view(64, 64);
        part.camera.window = {
            .left = double(cut), .right = cut + 64.0, .bottom = -cut - 64.0, .top = double(-cut)};
        const Frame frame = render(scene, part);
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                ASSERT_EQ(frame.primitive.at(x, y), whole.primitive.at(x + cut, y + cut))
                    << "cut " << cut << ", pixel " << x << ", " << y;
            }
        }
    }
}

}  // namespace
}  // namespace zproof::rasterizer
