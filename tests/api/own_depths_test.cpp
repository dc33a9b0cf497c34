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
