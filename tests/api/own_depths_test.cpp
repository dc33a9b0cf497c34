// Ids alone: what is wrong with an id is found, and nothing is wrong for want of a depth.
#include <gtest/gtest.h>

#include "scenes/suite.h"
#include "zproof/zproof.h"

namespace zproof::api {
namespace {

/// Kinds of precision, from a grid of whole pixels to exact depths.
const std::vector<std::string> precisions{
    "raster,subpixel_bits=8",
    "raster,subpixel_bits=0,depth_buffer=standard_z,depth_format=unorm16,matrix_far=finite", "ray", "opengl",
    "raster,transform=float64,interpolation=float64,depth_roundings=1"};

std::vector<std::uint32_t> ids_of(const Frame& frame) { return {frame.id().begin(), frame.id().end()}; }

TEST(IdsAlone, GetTheClassThatTheyGetWithRightDepths) {
    for (const SuiteEntry& entry : suite_manifest()) {
        if (entry.name == "million_triangles")
            continue;  // takes a minute, and has no kind of triangle of its own
        const Scene scene = Scene::load(entry.name, {80, 45});
        for (const View& view : scene.views()) {
            const Frame ours = render(scene, view);
            const std::string precision = "raster,transform=float64,subpixel_bits=8";
            const Verdict whole =
                judge(scene, view, {.id = ours.id(), .depth = ours.depth(), .precision = precision});
            const Verdict alone = judge(scene, view, {.id = ours.id(), .precision = precision});
            ASSERT_TRUE(whole.is_proven());
            EXPECT_TRUE(std::ranges::equal(whole.counts(), alone.counts()))
                << entry.name << " " << view.name();
        }
    }
}

TEST(IdsAlone, OfEmbreeAreProvenWhateverTheDepthsPrecision) {
    for (const char* name : {"room", "depth_range", "orthographic", "near_plane"}) {
        const Scene scene = Scene::load(name, {80, 45});
        for (const View& view : scene.views())
            for (const std::string& precision : precisions) {
                const Frame seen = trace(scene, view);
                const Verdict verdict = judge(scene, view, {.id = seen.id(), .precision = precision});
                EXPECT_EQ(verdict.defect_count(), 0u) << name << " " << view.name() << " " << precision;
            }
    }
}

/// No float32 lies within the bounds of what is never rounded.
TEST(IdsAlone, AreProvenWhereNoFloat32WouldKeepThePromise) {
    const Scene scene = Scene::load("room", {80, 45});
    const View view = scene.views().front();
    const Frame seen = trace(scene, view);
    for (const char* precision : {"bounded,eps_px=1e-9,depth_relative=0",
                                  "raster,transform=float64,subpixel_bits=16,snap=none,"
                                  "interpolation=float64,depth_roundings=0"}) {
        const Candidate whole{.id = seen.id(), .depth = seen.depth(), .precision = precision};
        EXPECT_GT(judge(scene, view, whole).defect_count(), 0u);
        EXPECT_EQ(judge(scene, view, {.id = seen.id(), .precision = precision}).defect_count(), 0u);
    }
}

/// Two walls at depths of 256 and 256 + gap, where a step of the buffer is one of depth, and every bound two:
/// that of z and of what tells it.
std::string class_of_wall_behind(float gap, bool has_depth) {
    std::vector<float> positions;
    for (const float z : {-256.f, -256.f - gap})
        for (const auto& [x, y] : {std::pair{-2000.f, -1000.f}, {2000.f, -1000.f}, {0.f, 3000.f}})
            positions.insert(positions.end(), {x, y, z});
    const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 4, 5};
    const Scene scene({.positions_world = positions, .triangles = triangles});
    const View view =
        View::perspective({.target = {0, 0, -1}, .near_depth = 1, .far_depth = 65536, .size = {4, 4}}, 1);
    const std::vector<std::uint32_t> ids(16, 1);
    const std::vector<float> depths(16, 256 + gap);
    const Verdict verdict =
        judge(scene, view,
              {.id = ids,
               .depth = has_depth ? std::span<const float>(depths) : std::span<const float>(),
               .precision =
                   "raster,depth_buffer=standard_z,depth_format=unorm16,depth_interpolation=barycentrics"});
    return std::string(class_names()[verdict.classes()[5]]);
}

/// Either wall may be shown; the one behind wins only at a depth that is less than its true one.
TEST(IdsAlone, OfAWallThatNeedsADepthBeforeItsOwnAreProven) {
    EXPECT_EQ(class_of_wall_behind(1.5f, true), "wrong_depth");
    EXPECT_EQ(class_of_wall_behind(1.5f, false), "depth_tie");
    EXPECT_EQ(class_of_wall_behind(2.5f, false), "hidden");
}

TEST(IdsAlone, ThatAreWrongAreFound) {
    const Scene scene = Scene::load("room", {160, 90});
    const View view = scene.views().front();
    std::vector<std::uint32_t> ids = ids_of(render(scene, view));
    const std::uint32_t right = ids[160 * 45 + 80];
    ids[160 * 45 + 80] = background_id;
    ids[160 * 45 + 90] = std::uint32_t(scene.triangle_count());
    ids[160 * 10 + 10] = ids[160 * 10 + 10] == right ? right + 1 : right;
    const Verdict verdict = judge(scene, view, {.id = ids, .precision = "raster,transform=float64"});
    EXPECT_EQ(verdict.defect_count(), 3u);
    EXPECT_EQ(class_names()[verdict.classes()[160 * 45 + 80]], "hole");
    EXPECT_EQ(class_names()[verdict.classes()[160 * 45 + 90]], "invalid");
}

}  // namespace
}  // namespace zproof::api
