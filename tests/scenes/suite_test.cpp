// What holds for every scene of the suite.
#include "scenes/suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

#include "scenes/scene_error.h"

namespace zproof {
namespace {

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

/// The scenes of every run, and those of thorough runs.
std::vector<SuiteEntry> everything() {
    std::vector<SuiteEntry> entries = suite_manifest();
    for (const SuiteEntry& entry : thorough_manifest()) entries.push_back(entry);
    return entries;
}

TEST(SuiteManifest, HasAtLeastSixteenScenesWithUniqueNamesAndReasons) {
    std::set<std::string> names, reasons;
    for (const SuiteEntry& entry : everything()) {
        SCOPED_TRACE(entry.name);
        EXPECT_TRUE(names.insert(entry.name).second);
        EXPECT_GE(entry.reason.size(), 40u);
        EXPECT_EQ(entry.reason.back(), '.');
        EXPECT_TRUE(reasons.insert(entry.reason).second);
    }
    EXPECT_GE(names.size(), 16u);
}

TEST(SuiteManifest, ExpectsEveryPassingClassOfDifferenceSomewhereAndNoOtherClass) {
    std::set<std::string> expected;
    for (const SuiteEntry& entry : suite_manifest()) {
        EXPECT_FALSE(entry.expects.empty()) << entry.name;
        expected.insert(entry.expects.begin(), entry.expects.end());
    }
    EXPECT_EQ(expected, (std::set<std::string>{"abutting_edges", "clip", "depth_tie", "edge"}));
}

TEST(Suite, RefusesAnUnknownNameAndNamesIt) {
    try {
        generate_suite_scene("no such scene");
        FAIL() << "no exception";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("no such scene"), std::string::npos);
    }
}

TEST(Suite, RefusesAnImageWithoutPixels) {
    EXPECT_THROW(generate_suite_scene("room", 0, 10), SceneError);
    EXPECT_THROW(generate_suite_scene("room", 10, -1), SceneError);
}

class EverySuiteScene : public testing::TestWithParam<std::string> {};

TEST_P(EverySuiteScene, IsNamedAsInTheManifestAndHasTriangles) {
    const Loaded loaded = generate_suite_scene(GetParam());
    EXPECT_EQ(loaded.scene.name, GetParam());
    EXPECT_FALSE(loaded.scene.triangles.empty());
    EXPECT_TRUE(loaded.scene.notes.empty());
}

TEST_P(EverySuiteScene, HasIndicesInRangeAndFinitePositions) {
    const Scene scene = generate_suite_scene(GetParam()).scene;
    const auto& positions = scene.vertices.position_world;
    for (const glm::uvec3& t : scene.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), positions.size());
    for (const glm::vec3& p : positions)
        for (const float coordinate : {p.x, p.y, p.z}) {
            ASSERT_TRUE(std::isfinite(coordinate));
            ASSERT_LE(std::abs(coordinate), 2e6f);
            ASSERT_FALSE(coordinate == 0 && std::signbit(coordinate))
                << "-0 does not survive a glTF transform";
        }
    for (const auto& uv : scene.vertices.uv) EXPECT_EQ(uv.size(), positions.size());
}

TEST_P(EverySuiteScene, HasPartsThatCoverEveryTriangleInOrderWithVerticesOfTheirOwn) {
    const Scene scene = generate_suite_scene(GetParam()).scene;
    std::uint32_t next_triangle = 0, next_vertex = 0;
    for (const Part& part : scene.parts) {
        SCOPED_TRACE(part.node);
        ASSERT_EQ(part.first_triangle, next_triangle);
        ASSERT_GT(part.triangle_count, 0u);
        next_triangle += part.triangle_count;
        ASSERT_GE(part.material, 0);
        ASSERT_LT(static_cast<std::size_t>(part.material), scene.materials.size());
        std::uint32_t highest = 0;
        for (std::uint32_t i = part.first_triangle; i < next_triangle; ++i) {
            const glm::uvec3& t = scene.triangles[i];
            ASSERT_GE(std::min({t.x, t.y, t.z}), next_vertex);
            highest = std::max({highest, t.x, t.y, t.z});
        }
        next_vertex = highest + 1;
    }
    EXPECT_EQ(next_triangle, scene.triangles.size());
    EXPECT_EQ(next_vertex, scene.vertices.position_world.size()) << "vertices that no triangle uses";
}

bool has_own_sizes(const std::string& name) {
    const std::vector<SuiteEntry> entries = suite_manifest();
    return std::ranges::find(entries, name, &SuiteEntry::name)->has_own_sizes;
}

TEST_P(EverySuiteScene, HasValidViewsOfTheSizeAskedForUnlessItHasSizesOfItsOwn) {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {641, 359}}) {
        const Loaded loaded = generate_suite_scene(GetParam(), width, height);
        EXPECT_GE(loaded.views.size(), 1u);
        std::set<std::string> names;
        for (const View& view : loaded.views) {
            SCOPED_TRACE(view.name);
            EXPECT_TRUE(names.insert(view.name).second);
            EXPECT_NO_THROW(validate(view.camera));
            if (has_own_sizes(GetParam())) continue;
            EXPECT_EQ(view.width, width);
            EXPECT_EQ(view.height, height);
            const Window& w = view.camera.window;
            EXPECT_NEAR((w.right - w.left) * height, (w.top - w.bottom) * width,
                        1e-9 * (w.right - w.left) * height)
                << "pixels are not square";
        }
    }
}

TEST_P(EverySuiteScene, HasTheSameBitsEveryTime) {
    const Loaded once = generate_suite_scene(GetParam()), again = generate_suite_scene(GetParam());
    EXPECT_EQ(once.scene.triangles, again.scene.triangles);
    const auto same_bits = [](const glm::vec3& a, const glm::vec3& b) {
        return std::bit_cast<std::array<std::uint32_t, 3>>(a) ==
               std::bit_cast<std::array<std::uint32_t, 3>>(b);
    };
    EXPECT_TRUE(std::ranges::equal(once.scene.vertices.position_world, again.scene.vertices.position_world,
                                   same_bits));
    ASSERT_EQ(once.views.size(), again.views.size());
    for (std::size_t i = 0; i < once.views.size(); ++i) {
        EXPECT_EQ(once.views[i].camera.eye_world, again.views[i].camera.eye_world);
        EXPECT_EQ(once.views[i].camera.back, again.views[i].camera.back);
        EXPECT_EQ(once.views[i].camera.window.left, again.views[i].camera.window.left);
    }
}

INSTANTIATE_TEST_SUITE_P(Suite, EverySuiteScene, testing::ValuesIn(scene_names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace zproof
