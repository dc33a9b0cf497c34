// Meshes as their default morph weights shape them.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

/// A triangle with a target that lifts it by z and one that is not weighted; its normals are +z.
WrittenGltf morphed_triangle() {
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = gltf.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int lifted = gltf.add_vec3({0, 0, 1, 0, 0, 2, 0, 0, 4});
    const int turned = gltf.add_vec3({0, 0, 0, 2, 0, -2, 0, 0, 0});
    const int broken = gltf.add_vec3({9, 9, 9});
    gltf.primitive()["attributes"]["NORMAL"] = normals;
    gltf.primitive()["targets"] = {{{"POSITION", lifted}, {"NORMAL", turned}}, {{"POSITION", broken}}};
    return gltf;
}

Scene scene_of(const WrittenGltf& gltf) {
    const TestFolder folder;
    return load_gltf_scene(gltf.write(folder));
}

TEST(GltfMorph, AppliesTheMeshsDefaultMorphWeights) {
    WrittenGltf gltf = morphed_triangle();
    gltf.json["meshes"][0]["weights"] = {0.5, 0};
    gltf.json["nodes"][0]["translation"] = {0, 0, 10};
    const Scene scene = scene_of(gltf);
    EXPECT_EQ(scene.vertices.position_world, (Positions{{0, 0, 10.5f}, {1, 0, 11}, {0, 1, 12}}));
    EXPECT_EQ(scene.vertices.normal_world[1], glm::vec3(1, 0, 0));
    EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
}

TEST(GltfMorph, ANodesMorphWeightsGoBeforeItsMeshs) {
    WrittenGltf gltf = morphed_triangle();
    gltf.json["meshes"][0]["weights"] = {0.5, 1};
    gltf.json["nodes"][0]["weights"] = {-1, 0};
    EXPECT_EQ(scene_of(gltf).vertices.position_world, (Positions{{0, 0, -1}, {1, 0, -2}, {0, 1, -4}}));
}

TEST(GltfMorph, MorphTargetsWithoutWeightsAreLeftAlone) {
    EXPECT_EQ(scene_of(morphed_triangle()).vertices.position_world,
              (Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(GltfMorph, MorphTargetsFollowTheVerticesInUse) {
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const int target = gltf.add_vec3({0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5});
    gltf.primitive()["indices"] = gltf.add_indices<std::uint8_t>({4, 2, 1}, 5121);
    gltf.primitive()["targets"] = {{{"POSITION", target}}};
    gltf.json["meshes"][0]["weights"] = {1};
    EXPECT_EQ(scene_of(gltf).vertices.position_world, (Positions{{1, 0, 2}, {0, 1, 3}, {0, 2, 5}}));
}

TEST(GltfMorph, RefusesAWeightedMorphTargetOfAnotherSize) {
    const TestFolder folder;
    WrittenGltf gltf = morphed_triangle();
    gltf.json["meshes"][0]["weights"] = {0, 1};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/accessors/4: a morph target's POSITION: expected 3 VEC3"),
              std::string::npos);
    gltf.json["meshes"][0]["weights"] = {"much"};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/meshes/0/weights/0: expected a number"),
              std::string::npos);
}

TEST(GltfMorph, NotesMorphTargetsThatItDoesNotApply) {
    WrittenGltf gltf = morphed_triangle();
    gltf.primitive()["targets"][0]["COLOR_0"] = 0;
    gltf.json["meshes"][0]["weights"] = {1, 0};
    EXPECT_EQ(scene_of(gltf).notes,
              (std::vector<std::string>{"morph targets of TEXCOORD and COLOR not applied: 1"}));
}

}  // namespace
}  // namespace zproof
