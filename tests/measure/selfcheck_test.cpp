// Renderers that contradict themselves, each by one variant at least; and one that does not.
#include "measure/selfcheck/selfcheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::measure {
namespace {

using Render = Frame (*)(const Scene&, const View&);

Frame render_well(const Scene& scene, const View& view) { return rasterizer::render(scene, view); }

Frame loses_the_last_triangle(const Scene& scene, const View& view) {
    Scene shorter = scene;
    shorter.triangles.resize(scene.triangles.size() * 9 / 10);
    return rasterizer::render(shorter, view);
}

/// What a triangle's winding decides in NDC, by the corners' order alone.
Frame drops_back_faces(const Scene& scene, const View& view) {
    Scene facing = scene;
    for (glm::uvec3& t : facing.triangles) {
        const auto from_eye = [&](std::uint32_t v) {
            return glm::dvec3(scene.vertices.position_world[v]) - glm::dvec3(view.camera.eye_world);
        };
        const glm::dvec3 a = from_eye(t.x), normal = glm::cross(from_eye(t.y) - a, from_eye(t.z) - a);
        if (glm::dot(normal, a) > 0) t = glm::uvec3(t.x);
    }
    return rasterizer::render(facing, view);
}

Frame ignores_the_windows_offset(const Scene& scene, const View& view) {
    View centred = view;
    Window& w = centred.camera.window;
    const double half = 0.5 * (w.right - w.left);
    w.left = -half;
    w.right = half;
    return rasterizer::render(scene, centred);
}

Frame drops_large_triangles(const Scene& scene, const View& view) {
    Scene small = scene;
    for (glm::uvec3& t : small.triangles) {
        const glm::vec3 a = scene.vertices.position_world[t.x];
        if (glm::distance(a, scene.vertices.position_world[t.y]) > 2) t = glm::uvec3(t.x);
    }
    return rasterizer::render(small, view);
}

Frame stands_aside_by_a_third_of_a_pixel(const Scene& scene, const View& view) {
    View moved = view;
    const double pixel = (view.camera.window.right - view.camera.window.left) / view.width;
    moved.camera.window.left += 0.3 * pixel;  // 0.3 px of this picture, whatever its size
    moved.camera.window.right += 0.3 * pixel;
    return rasterizer::render(scene, moved);
}

Frame loses_the_last_tile(const Scene& scene, const View& view) {
    Frame frame = rasterizer::render(scene, view);
    for (int y = 0; y < view.height; ++y)
        for (int x = view.width / 16 * 16; x < view.width; ++x) {
            frame.primitive.at(x, y) = PrimitiveId::none;
            frame.camera_depth.at(x, y) = background_depth;
        }
    return frame;
}

Frame sees_only_positive_x(const Scene& scene, const View& view) {
    Scene half = scene;
    for (glm::uvec3& t : half.triangles)
        if (scene.vertices.position_world[t.x].x < -1) t = glm::uvec3(t.x);
    return rasterizer::render(half, view);
}

/// Does the variant find fault, in a view of these scenes? Empty: does any?
bool is_found(Render render, const std::string& name, Resolution size = {160, 90}) {
    const Renderer renderer{.name = "subject", .render = render, .declared = rasterizer::precision()};
    for (const char* scene : {"room", "off_axis", "oblique"}) {
        const Loaded loaded = generate_suite_scene(scene, size.width, size.height);
        for (const View& view : loaded.views)
            for (const Variant& variant : variants()) {
                if (!name.empty() && variant.name != name) continue;
                const VariantResult result =
                    check_variant(renderer, loaded.scene, view, render(loaded.scene, view), variant);
                EXPECT_EQ(result.first_defect.empty(), result.defects + result.original_defects == 0);
                if (!result.first_defect.empty()) return true;
            }
    }
    return false;
}

TEST(Selfcheck, FindsNoFaultWithWhoIsRight) {
    EXPECT_FALSE(is_found(render_well, ""));
    EXPECT_FALSE(is_found(render_well, "", {67, 131}));
}

TEST(Selfcheck, FindsFaultByTheVariantThatTheDefectCannotBear) {
    EXPECT_TRUE(is_found(loses_the_last_triangle, "reversed order"));
    EXPECT_TRUE(is_found(drops_back_faces, "other winding"));
    EXPECT_TRUE(is_found(drops_large_triangles, "split in two"));
    EXPECT_TRUE(is_found(ignores_the_windows_offset, "moved by whole pixels"));
    EXPECT_TRUE(is_found(sees_only_positive_x, "mirrored"));
    EXPECT_TRUE(is_found(stands_aside_by_a_third_of_a_pixel, "three times as large"));
    EXPECT_TRUE(is_found(loses_the_last_tile, "cut into tiles", {165, 90}));
}

Frame draws_nothing(const Scene&, const View& view) { return Frame({view.width, view.height}); }

/// Draws half of the scene, and no two of its frames have the same bits.
Frame draws_half_unsteadily(const Scene& scene, const View& view) {
    static int frame_count = 0;
    Frame frame = sees_only_positive_x(scene, view);
    float& depth =
        *std::ranges::find_if(frame.camera_depth.pixels(), [](float d) { return std::isfinite(d); });
    if (++frame_count % 2 == 0) depth = std::nextafter(depth, 0.f);
    return frame;
}

TEST(Selfcheck, AsksTheSceneWhereTwoFramesHaveTheSameBits) { EXPECT_TRUE(is_found(draws_nothing, "")); }

TEST(Selfcheck, TellsNothingOfAnErrorThatAllVariantsShare) {
    EXPECT_TRUE(is_found(sees_only_positive_x, "reversed order"));
    EXPECT_FALSE(is_found(draws_half_unsteadily, "reversed order"));
}

TEST(Selfcheck, HoldsForARayCasterByItsOwnPromise) {
    const Renderer embree{
        .name = "embree",
        .render = [](const Scene& scene, const View& view) { return oracle::Embree(scene).trace(view); },
        .declared = oracle::embree_precision()};
    for (const char* scene : {"room", "oblique", "parallel_planes"}) {
        const Loaded loaded = generate_suite_scene(scene, 160, 90);
        for (const View& view : loaded.views)
            for (const Variant& variant : variants()) {
                const auto result =
                    check_variant(embree, loaded.scene, view, embree.render(loaded.scene, view), variant);
                EXPECT_EQ(result.defects + result.original_defects, 0u)
                    << variant.name << result.first_defect;
                EXPECT_TRUE(result.was_drawn);
            }
    }
}

TEST(Selfcheck, SaysSoWhereAViewHasNoSuchPicture) {
    const Loaded loaded = generate_suite_scene("picture_sizes");
    const Renderer renderer{.name = "subject", .render = render_well, .declared = rasterizer::precision()};
    std::set<std::string> not_drawn;
    for (const View& view : loaded.views)
        for (const Variant& variant : variants())
            if (!check_variant(renderer, loaded.scene, view, render_well(loaded.scene, view), variant)
                     .was_drawn)
                not_drawn.insert(view.name + ", " + variant.name);
    EXPECT_TRUE(not_drawn.contains("one-pixel, cut into tiles"));
    EXPECT_TRUE(not_drawn.contains("one-row, moved by whole pixels"));
    EXPECT_TRUE(not_drawn.contains("wider-than-8192, three times as large"));
    EXPECT_FALSE(not_drawn.contains("odd, cut into tiles"));
}

}  // namespace
}  // namespace zproof::measure
