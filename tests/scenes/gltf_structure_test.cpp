#include "scenes/gltf_structure.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

using nlohmann::json;

TEST(GltfStructure, FillsInWhatGltfHasByDefault) {
    const tinygltf::Model model = structure_of(json::parse(R"({
        "bufferViews": [{"buffer": 2, "byteLength": 12}],
        "accessors": [{"componentType": 5126, "count": 1, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{}], "materials": [{}], "textures": [{}], "samplers": [{}], "scenes": [{}]})"));
    EXPECT_EQ(model.defaultScene, -1);
    EXPECT_EQ(model.bufferViews[0].byteOffset, 0u);
    EXPECT_EQ(model.bufferViews[0].byteStride, 0u);
    EXPECT_EQ(model.accessors[0].bufferView, -1);
    EXPECT_FALSE(model.accessors[0].normalized);
    EXPECT_FALSE(model.accessors[0].sparse.isSparse);
    EXPECT_EQ(model.meshes[0].primitives[0].mode, TINYGLTF_MODE_TRIANGLES);
    EXPECT_EQ(model.meshes[0].primitives[0].indices, -1);
    EXPECT_EQ(model.meshes[0].primitives[0].material, -1);
    EXPECT_EQ(model.nodes[0].mesh, -1);
    EXPECT_EQ(model.nodes[0].camera, -1);
    EXPECT_EQ(model.nodes[0].skin, -1);
    EXPECT_TRUE(model.nodes[0].matrix.empty());
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorTexture.index, -1);
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorFactor, (std::vector<double>{1, 1, 1, 1}));
    EXPECT_EQ(model.textures[0].sampler, -1);
    EXPECT_EQ(model.textures[0].source, -1);
    EXPECT_EQ(model.samplers[0].minFilter, -1);
    EXPECT_EQ(model.samplers[0].wrapT, TINYGLTF_TEXTURE_WRAP_REPEAT);
}

TEST(GltfStructure, KeepsWhatTheFileSays) {
    const tinygltf::Model model = structure_of(json::parse(R"({
        "scene": 0, "scenes": [{"nodes": [1, 0]}],
        "nodes": [{"name": "a",
                   "children": [1], "scale": [1, 2, 3]}, {"rotation": [0, 0, 0, 1], "camera": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.25}}],
        "accessors": [{"componentType": 5121, "count": 9, "type": "SCALAR", "normalized": true,
            "sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 4},
                       "values": {"bufferView": 2}}}],
        "materials": [{"name": "m", "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4],
            "baseColorTexture": {"index": 0, "texCoord": 1}}}]})"));
    EXPECT_EQ(model.scenes[0].nodes, (std::vector<int>{1, 0}));
    EXPECT_EQ(model.nodes[0].children, std::vector<int>{1});
    EXPECT_EQ(model.nodes[0].scale, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(model.cameras[model.nodes[1].camera == 0 ? 0 : 1].perspective.znear, 0.25);
    EXPECT_EQ(model.cameras[0].perspective.zfar, 0);
    EXPECT_TRUE(model.accessors[0].normalized);
    EXPECT_EQ(model.accessors[0].type, TINYGLTF_TYPE_SCALAR);
    EXPECT_EQ(model.accessors[0].sparse.count, 2);
    EXPECT_EQ(model.accessors[0].sparse.indices.byteOffset, 4);
    EXPECT_EQ(model.accessors[0].sparse.values.bufferView, 2);
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorFactor[3], 0.4);
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorTexture.texCoord, 1);
}

TEST(GltfStructure, LeavesOutExtensionsThatAreNoObjectsAndMembersThatAreNull) {
    const tinygltf::Model model = structure_of(json::parse(R"({"nodes": [
        {"extensions": {"A": {"x": null, "y": [1, 2.5, null], "z": {"deep": "text"}}, "B": 3}},
        {"extensions": 7}]})"));
    const tinygltf::ExtensionMap& extensions = model.nodes[0].extensions;
    ASSERT_EQ(extensions.size(), 1u);
    EXPECT_FALSE(extensions.at("A").Has("x"));
    ASSERT_EQ(extensions.at("A").Get("y").ArrayLen(), 2u);
    EXPECT_EQ(extensions.at("A").Get("y").Get(1).GetNumberAsDouble(), 2.5);
    EXPECT_EQ(extensions.at("A").Get("z").Get("deep").Get<std::string>(), "text");
    EXPECT_TRUE(model.nodes[1].extensions.empty());
}

}  // namespace
}  // namespace zproof
