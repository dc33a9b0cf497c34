// Scenes of arrays and of files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "scenes/suite.h"
#include "tests/support/test_folder.h"
#include "zproof/data.h"
#include "zproof/zproof.h"

namespace zproof::api {
namespace {

const std::vector<float> square{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
const std::vector<std::uint32_t> halves{0, 1, 2, 0, 2, 3};

std::string refusal_of(const Mesh& mesh) {
    try {
        const Scene scene{mesh};
        return "";
    } catch (const InputError& e) {
        return e.what();
    }
}

TEST(ApiScene, OfArraysHoldsThem) {
    const Scene scene{{.positions_world = square, .triangles = halves}};
    EXPECT_EQ(scene.vertex_count(), 4u);
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_TRUE(std::ranges::equal(scene.positions_world(), square));
    EXPECT_TRUE(std::ranges::equal(scene.triangles(), halves));
    EXPECT_TRUE(scene.views().empty());
}

TEST(ApiScene, WhatDoesNotFitIsNamed) {
    const std::vector<std::uint32_t> beyond{0, 1, 2, 0, 4, 3};
    EXPECT_EQ(refusal_of({square, beyond}), "scene: triangle 1 names vertex 4; there are 4");
    EXPECT_EQ(refusal_of({std::span(square).first(11), halves}), "scene: positions come in threes");
    EXPECT_EQ(refusal_of({square, std::span(halves).first(5)}), "scene: triangles come in threes");
    const std::vector<float> uv{0, 0, 1, 0};
    EXPECT_EQ(refusal_of({square, halves, uv}), "scene: uv has 2 vertices, positions have 4");
    std::vector<float> not_finite = square;
    not_finite[4] = std::nanf("");
    EXPECT_NE(refusal_of({not_finite, halves}), "");
    not_finite[4] = 1e12f;
    EXPECT_NE(refusal_of({not_finite, halves}), "");
    const std::vector<std::uint8_t> texels(4 * 6);
    EXPECT_EQ(refusal_of({square, halves, {}, texels, {2, 3}}), "scene: a texture needs uv");
    const std::vector<float> uv_of_all(8);
    EXPECT_EQ(refusal_of({square, halves, uv_of_all, texels, {2, 2}}),
              "scene: the texture's size is not that of its texels");
    EXPECT_EQ(refusal_of({square, halves, uv_of_all, texels, {2, 3}}), "");
}

TEST(ApiScene, OfTheSuiteIsTheSuites) {
    const Scene scene = Scene::load("guard_band", {64, 40});
    const Loaded own = generate_suite_scene("guard_band", 64, 40);
    EXPECT_EQ(scene.triangle_count(), own.scene.triangles.size());
    ASSERT_EQ(scene.views().size(), own.views.size());
    EXPECT_EQ(scene.views().front().name(), own.views.front().name);
    EXPECT_EQ(scene.views().front().size(), (Size{64, 40}));
}

TEST(ApiScene, WhatCannotBeLoadedIsNamed) {
    for (const char* name : {"no_such_scene", "missing.glb", "missing.json", "missing.obj", ""})
        EXPECT_THROW(Scene::load(name), InputError) << name;
    EXPECT_THROW(Scene::load("guard_band", {32769, 1}), InputError);
    EXPECT_THROW(Scene::load("guard_band", {64, 0}), InputError);
}

TEST(ApiScene, SavedAndLoadedItIsTheSameBits) {
    const TestFolder own;
    const std::filesystem::path folder = own.path();
    const Scene scene{{.positions_world = square, .triangles = halves, .name = "square"}};
    const std::vector<View> views{View::from_opencv(
        {.K = {30, 0, 15.5, 0, 31, 11.5, 0, 0, 1}, .t = {0.1, 0.2, 3.3}}, {32, 24}, 0.1, 10, "cam")};
    save(scene, views, folder.string());
    const Scene back = Scene::load((folder / "square.view.json").string());
    EXPECT_TRUE(std::ranges::equal(back.positions_world(), square));
    EXPECT_TRUE(std::ranges::equal(back.triangles(), halves));
    ASSERT_EQ(back.views().size(), 1u);
    EXPECT_EQ(back.views().front().opencv().K, views.front().opencv().K);
    EXPECT_EQ(back.views().front().opencv().t, views.front().opencv().t);
    EXPECT_THROW(save(scene, views, (folder / "absent").string()), InputError);
}

}  // namespace
}  // namespace zproof::api
