#include "scenes/triangle_labels.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "scenes/cryptomatte.h"
#include "scenes/scene_error.h"
#include "tests/support/test_folder.h"

namespace zproof {
namespace {

using Labels = std::vector<std::uint32_t>;

/// Two wheels of one material and a frame of another, with 1, 2 and 1 triangles.
Scene bicycle() {
    Scene scene;
    scene.triangles.resize(4);
    scene.materials = {{.name = "steel", .base_color = {}}, {.name = "rubber", .base_color = {}}};
    scene.parts = {{.node = "front",
                    .mesh = "wheel",
                    .first_triangle = 0,
                    .triangle_count = 1,
                    .material = 1,
                    .node_index = 4},
                   {.node = "frame",
                    .mesh = "frame",
                    .first_triangle = 1,
                    .triangle_count = 2,
                    .material = 0,
                    .node_index = 2},
                   {.node = "rear",
                    .mesh = "wheel",
                    .first_triangle = 3,
                    .triangle_count = 1,
                    .material = 1,
                    .node_index = 5}};
    return scene;
}

TEST(TriangleLabels, AreWhatTheSceneKnows) {
    const Scene scene = bicycle();
    EXPECT_EQ(label_triangles("primitive", scene).of_triangle, (Labels{0, 1, 1, 2}));
    EXPECT_EQ(label_triangles("node", scene).of_triangle, (Labels{4, 2, 2, 5}));
    EXPECT_EQ(label_triangles("node", scene).names.at(5), "rear");
    const TriangleLabels material = label_triangles("material", scene);
    EXPECT_EQ(material.of_triangle, (Labels{1, 0, 0, 1}));
    EXPECT_EQ(material.names.at(1), "rubber");
    EXPECT_EQ(material.background, Labels{0xFFFF'FFFF});
    EXPECT_FALSE(material.are_absent);
}

TEST(TriangleLabels, CountPrimitivesThatHaveTriangles) {
    Scene scene = bicycle();
    scene.parts.insert(scene.parts.begin() + 1, Part{.node = "nothing", .mesh = "", .first_triangle = 1});
    EXPECT_EQ(label_triangles("primitive", scene).of_triangle, (Labels{0, 1, 1, 2}));
}

TEST(TriangleLabels, OfDepthAloneAreAllTheSame) {
    const TriangleLabels none = label_triangles("none", bicycle());
    EXPECT_EQ(none.of_triangle, (Labels{0, 0, 0, 0}));
    EXPECT_TRUE(none.are_absent);
}

TEST(TriangleLabels, OfCryptomatteAreHashesOfNames) {
    const TriangleLabels object = label_triangles("cryptomatte-object", bicycle());
    EXPECT_EQ(object.of_triangle[3], cryptomatte_id("rear"));
    EXPECT_EQ(object.names.at(cryptomatte_id("frame")), "frame");
    EXPECT_EQ(object.background, (Labels{0xFFFF'FFFF, 0}));
    EXPECT_EQ(label_triangles("cryptomatte-material", bicycle()).of_triangle[0], cryptomatte_id("rubber"));
}

/// Values of the public domain code.
TEST(Cryptomatte, HashesAsMurmurHash3Does) {
    EXPECT_EQ(murmur_hash3(""), 0u);
    EXPECT_EQ(murmur_hash3("test"), 0xBA6BD213u);
    EXPECT_EQ(murmur_hash3("Hello, world!"), 0xC0363E43u);
    EXPECT_EQ(murmur_hash3("The quick brown fox jumps over the lazy dog"), 0x2E4FF723u);
}

TEST(Cryptomatte, GivesFloatsThatAreFiniteAndNormal) {
    int turned = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::string name = "object" + std::to_string(i);
        const std::uint32_t id = cryptomatte_id(name), exponent = id >> 23 & 0xFF;
        ASSERT_NE(exponent, 0u) << name;
        ASSERT_NE(exponent, 0xFFu) << name;
        turned += id != murmur_hash3(name);
    }
    EXPECT_GT(turned, 100);
}

class ALabelFile : public testing::Test {
  protected:
    Labels read(const std::string& text) const {
        return label_triangles(folder.write("labels.json", text), bicycle()).of_triangle;
    }
    std::string refusal_of(const std::string& text) const {
        try {
            read(text);
        } catch (const SceneError& e) {
            return std::string(e.what()).substr((folder.path() / "labels.json").string().size() + 2);
        }
        return "";
    }
    TestFolder folder;
};

TEST_F(ALabelFile, ListsTrianglesOrRunsOfThem) {
    EXPECT_EQ(read("[3, 0, 4294967294, 3]"), (Labels{3, 0, 4294967294, 3}));
    EXPECT_EQ(read(R"([{"count": 3, "label": 8}, 9])"), (Labels{8, 8, 8, 9}));
    EXPECT_EQ(read(R"([{"label": 8, "count": 4}, {"count": 0, "label": 1}])"), (Labels{8, 8, 8, 8}));
}

TEST_F(ALabelFile, ThatDoesNotFitIsRefused) {
    EXPECT_EQ(refusal_of("[1, 2, 3]"), "/: labels for 3 triangles; the scene has 4");
    EXPECT_EQ(refusal_of("[1, 2, 3, 4, 5]"), "/4: a label beyond the last of the scene's 4 triangles");
    EXPECT_EQ(refusal_of(R"([{"count": 5, "label": 8}])"),
              "/0: a label beyond the last of the scene's 4 triangles");
    EXPECT_EQ(refusal_of("[1, 2, -3, 4]"), "/2: expected a whole number from 0 to 4294967295");
    EXPECT_EQ(refusal_of("[1, 2, 3.5, 4]"), "/2: expected a whole number from 0 to 4294967295");
    EXPECT_EQ(refusal_of("[1, 2, 4294967296, 4]"), "/2: expected a whole number from 0 to 4294967295");
    EXPECT_EQ(refusal_of("[1, 2, 4294967295, 4]"), "/2: 4294967295 means background; expected another label");
    EXPECT_EQ(refusal_of(R"([{"count": 4}])"), R"(/0: expected an object with "count" and "label")");
    EXPECT_EQ(refusal_of(R"([{"count": 4, "label": "wood"}])"),
              "/0/label: expected a whole number from 0 to 4294967295");
    EXPECT_EQ(
        refusal_of("{}"),
        "/: expected a label for each triangle, [0, 0, 7], or runs of them, [{\"count\": 12, \"label\": 7}]");
    EXPECT_NE(refusal_of("wood"), "");
}

}  // namespace
}  // namespace zproof
