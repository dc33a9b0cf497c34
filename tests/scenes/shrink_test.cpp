// What shrinks for as long as a planted question is answered with yes.
#include "scenes/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/judged_ranges.h"
#include "scenes/random_scenes.h"
#include "scenes/scene_hash.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

SceneAndView random_one(const char* word) {
    Loaded made = generate(random_scene_from(word).value());
    return {std::move(made.scene), made.views[0]};
}

/// A crowd in an ordinary view.
SceneAndView crowd() {
    for (std::uint64_t number = 0;; ++number) {
        SceneAndView one = random_one(("random:soup:3:" + std::to_string(number)).c_str());
        if (one.scene.triangles.size() == 500 && one.view.width > 30 && one.view.height > 30) return one;
    }
}

bool has_corner(const Scene& scene, const glm::vec3& p) {
    return std::ranges::count(scene.vertices.position_world, p) > 0;
}

TEST(Shrink, LeavesTheOneTriangleThatMattersInOnePixel) {
    const SceneAndView all = crowd();
    const float limit = all.scene.vertices.position_world[all.scene.triangles[321].y].x;
    const auto fails = [&](const SceneAndView& at) {
        return std::ranges::any_of(at.scene.vertices.position_world,
                                   [&](const glm::vec3& p) { return p.x == limit; });
    };
    const auto [least, tries] = shrink(all, fails);
    EXPECT_TRUE(fails(least));
    EXPECT_EQ(least.scene.triangles.size(), 1u);
    EXPECT_EQ(least.scene.vertices.position_world.size(), 3u);
    EXPECT_EQ(least.scene.parts.size(), 1u);
    EXPECT_EQ(least.scene.parts[0].triangle_count, 1u);
    EXPECT_EQ(least.view.width * least.view.height, 1);
    EXPECT_LT(tries, 250);
}

TEST(Shrink, LeavesBothOfTwoTrianglesAndTheirOrder) {
    SceneAndView all = crowd();
    const glm::vec3 first = all.scene.vertices.position_world[all.scene.triangles[17].x],
                    second = all.scene.vertices.position_world[all.scene.triangles[402].z];
    const auto fails = [&](const SceneAndView& at) {
        return has_corner(at.scene, first) && has_corner(at.scene, second);
    };
    const Scene& least = shrink(all, fails).least.scene;
    ASSERT_EQ(least.triangles.size(), 2u);
    EXPECT_EQ(least.vertices.position_world[least.triangles[0].x], first);
    EXPECT_EQ(least.vertices.position_world[least.triangles[1].z], second);
}

/// Where the view ray of a pixel meets the plane that the window is on.
glm::dvec2 aimed_at(const View& view, int x, int y) {
    const Window& w = view.camera.window;
    return {w.left + (w.right - w.left) * (x + 0.5) / view.width,
            w.top - (w.top - w.bottom) * (y + 0.5) / view.height};
}

TEST(Shrink, CropsThePictureToThePixelThatMattersAndKeepsItsRay) {
    const SceneAndView all = crowd();
    const glm::dvec2 aim = aimed_at(all.view, 19, 7);
    const auto fails = [&](const SceneAndView& at) {
        for (int y = 0; y < at.view.height; ++y)
            for (int x = 0; x < at.view.width; ++x)
                if (glm::length(aimed_at(at.view, x, y) - aim) <= 1e-13 * glm::length(aim)) return true;
        return false;
    };
    const View least = shrink(all, fails).least.view;
    EXPECT_EQ(least.width * least.height, 1);
    EXPECT_TRUE(fails({all.scene, least}));
}

TEST(Shrink, ShortensNumbersAndMakesTheCameraPlain) {
    SceneAndView all = random_one("random:soup:5:0");
    all.view.camera.eye_world = {0.3f, 17.7f, -3.1f};
    const auto fails = [](const SceneAndView& at) { return !at.scene.triangles.empty(); };
    const auto [scene, view] = shrink(all, fails).least;
    EXPECT_EQ(view.camera.eye_world, glm::vec3(0));
    EXPECT_EQ(glm::dmat3(view.camera.right, view.camera.up, view.camera.back), glm::dmat3(1));
    EXPECT_EQ(view.camera.ndc_depth, NdcDepth::minus_one_to_one);
    for (const glm::vec3& p : scene.vertices.position_world) EXPECT_EQ(p, glm::vec3(0));
}

TEST(Shrink, RoundsANumberOnlyAsFarAsItStillFails) {
    SceneAndView all = random_one("random:soup:5:0");
    all.scene.vertices.position_world[0].x = 0.3f;
    const auto fails = [](const SceneAndView& at) {
        return std::ranges::any_of(at.scene.vertices.position_world,
                                   [](const glm::vec3& p) { return p.x > 0.29f && p.x < 0.32f; });
    };
    const Scene least = shrink(all, fails).least.scene;
    EXPECT_TRUE(std::ranges::any_of(least.vertices.position_world,
                                    [](const glm::vec3& p) { return p.x == 0.3125f; }));
}

TEST(Shrink, AsksOnlyOfWhatIsJudgedAndNoOftenerThanItMay) {
    int asked = 0;
    const auto fails = [&](const SceneAndView& at) {
        ++asked;
        EXPECT_EQ(outside_judged_ranges(at.scene) + outside_judged_ranges(at.view), "");
        EXPECT_NO_THROW(validate(at.view.camera));
        return asked % 3 == 0;
    };
    const Shrunk shrunk = shrink(random_one("random:mixed:2:11"), fails, {.most_tries = 70});
    EXPECT_EQ(shrunk.tries, 70);
    EXPECT_EQ(asked, 70);
}

TEST(Shrink, StopsAtOnceAndKeepsTheLeastSoFar) {
    bool stopped = false;
    int asked = 0;
    const auto fails = [&](const SceneAndView&) {
        stopped = ++asked == 4;
        return true;
    };
    const SceneAndView all = crowd();
    const auto [least, tries] = shrink(all, fails, {.is_stopped = [&] { return stopped; }});
    EXPECT_EQ(asked, 4);
    EXPECT_EQ(tries, 4);
    EXPECT_EQ(least.scene.triangles.size(), 1u);
    EXPECT_EQ(least.view.width, all.view.width) << "the fourth answer is void: it came after the end";
}

TEST(Shrink, LeavesWhatDoesNotFailSmallerAsItIs) {
    const SceneAndView all = random_one("random:clipped:2:5");
    const auto never = [](const SceneAndView&) { return false; };
    const SceneAndView least = shrink(all, never).least;
    EXPECT_EQ(sha256_of(least.scene), sha256_of(all.scene));
    EXPECT_EQ(view_document("", {{least.view}}), view_document("", {{all.view}}));
}

}  // namespace
}  // namespace zproof
