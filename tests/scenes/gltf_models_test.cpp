/// Every valid model of the shared collection against the facts that its manifest states.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <tuple>

#include "scenes/gltf/accessor.h"
#include "scenes/gltf/bake.h"
#include "scenes/gltf/gltf.h"
#include "scenes/gltf/model.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path models = fs::path(ZPROOF_SHARED) / "models";

json manifest() {
    std::ifstream stream(models / "manifest.json");
    return stream ? json::parse(stream) : json::array();
}

/// Mesh instances whose transform turns right into left.
int mirrored_instances(const GltfModel& model) {
    int mirrored = 0;
    for (const PlacedNode& placed : placed_nodes(model))
        mirrored += at(model.document.nodes, placed.node).mesh >= 0 &&
                    glm::determinant(glm::dmat3(placed.world_from_node)) < 0;
    return mirrored;
}

void expect_sound(const Scene& scene) {
    std::uint32_t next = 0;
    for (const Part& part : scene.parts) {
        ASSERT_EQ(part.first_triangle, next);
        ASSERT_LT(static_cast<std::size_t>(part.material), scene.materials.size());
        next += part.triangle_count;
    }
    EXPECT_EQ(next, scene.triangles.size());
    const std::size_t size = scene.vertices.position_world.size();
    for (const glm::uvec3& t : scene.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), size);
    const auto empty_or_whole = [size](const auto& attribute) {
        return attribute.empty() || attribute.size() == size;
    };
    EXPECT_TRUE(empty_or_whole(scene.vertices.normal_world));
    EXPECT_TRUE(empty_or_whole(scene.vertices.color));
    for (const auto& uv : scene.vertices.uv) EXPECT_TRUE(empty_or_whole(uv));
    for (const Material& material : scene.materials) {
        if (material.base_color.image == Texture::none) continue;
        ASSERT_LT(static_cast<std::size_t>(material.base_color.image), scene.images.size());
        ASSERT_LT(static_cast<std::size_t>(material.base_color.uv_set), scene.vertices.uv.size());
    }
    for (const Image& image : scene.images)
        EXPECT_EQ(image.texels.size(), 4u * static_cast<unsigned>(image.width * image.height));
}

TEST(GltfModels, MatchTheirManifest) {
    const json entries = manifest();
    ASSERT_EQ(entries.size(), 66u) << "expected the shared models in " << models;
    for (const json& entry : entries) {
        const std::string file = entry["file"];
        SCOPED_TRACE(file);
        const Loaded loaded = load_gltf(models / file);
        EXPECT_EQ(loaded.scene.triangles.size(), entry["drawn"].get<std::size_t>());
        const std::size_t cameras = entry["cameras"].size();
        EXPECT_EQ(loaded.views.size(), std::max<std::size_t>(cameras, 1));
        EXPECT_EQ(loaded.views.front().name == "frame-all", cameras == 0);
        EXPECT_EQ(loaded.scene.images.empty(), entry["textures"] == 0);
        EXPECT_EQ(mirrored_instances(read_gltf(models / file)), entry["mirrored"].get<int>());
        expect_sound(loaded.scene);
        for (const View& view : loaded.views) EXPECT_NO_THROW(validate(view.camera));
    }
}

tinygltf::Model tinygltf_model(const fs::path& file) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(file.extension() == ".glb"
                    ? loader.LoadBinaryFromFile(&model, &error, &warning, file.string())
                    : loader.LoadASCIIFromFile(&model, &error, &warning, file.string()))
        << error;
    return model;
}

void expect_same_meshes(const gltf::Document& ours, const tinygltf::Model& theirs) {
    ASSERT_EQ(ours.meshes.size(), theirs.meshes.size());
    for (std::size_t mesh = 0; mesh < ours.meshes.size(); ++mesh) {
        EXPECT_EQ(ours.meshes[mesh].name, theirs.meshes[mesh].name);
        ASSERT_EQ(ours.meshes[mesh].primitives.size(), theirs.meshes[mesh].primitives.size());
        for (std::size_t i = 0; i < ours.meshes[mesh].primitives.size(); ++i) {
            const gltf::Primitive& own = ours.meshes[mesh].primitives[i];
            const tinygltf::Primitive& their = theirs.meshes[mesh].primitives[i];
            EXPECT_EQ(own.attributes, their.attributes);
            EXPECT_EQ(own.targets, their.targets);
            EXPECT_EQ(std::tuple(own.indices, own.material, own.mode),
                      std::tuple(their.indices, their.material, their.mode));
        }
    }
}

void expect_same_accessors(const gltf::Document& ours, const tinygltf::Model& theirs) {
    ASSERT_EQ(ours.accessors.size(), theirs.accessors.size());
    for (std::size_t i = 0; i < ours.accessors.size(); ++i) {
        const gltf::Accessor& own = ours.accessors[i];
        const tinygltf::Accessor& their = theirs.accessors[i];
        EXPECT_EQ(std::tuple(own.bufferView, own.componentType, own.byteOffset, own.count, own.normalized),
                  std::tuple(their.bufferView, their.componentType, their.byteOffset, their.count,
                             their.normalized));
        EXPECT_EQ(component_count(own.type),
                  tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(their.type)));
        EXPECT_EQ(component_bytes(own.componentType),
                  tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(their.componentType)));
        EXPECT_EQ(std::pair(own.min, own.max), std::pair(their.minValues, their.maxValues));
        EXPECT_EQ(own.sparse.count > 0, their.sparse.isSparse);
    }
    ASSERT_EQ(ours.bufferViews.size(), theirs.bufferViews.size());
    for (std::size_t i = 0; i < ours.bufferViews.size(); ++i) {
        const gltf::BufferView& own = ours.bufferViews[i];
        const tinygltf::BufferView& their = theirs.bufferViews[i];
        EXPECT_EQ(std::tuple(own.buffer, own.byteOffset, own.byteLength, own.byteStride),
                  std::tuple(their.buffer, their.byteOffset, their.byteLength, their.byteStride));
    }
    ASSERT_EQ(ours.buffers.size(), theirs.buffers.size());
    for (std::size_t i = 0; i < ours.buffers.size(); ++i)
        EXPECT_TRUE(std::ranges::equal(ours.buffers[i].data(), theirs.buffers[i].data)) << i;
}

void expect_same_nodes(const gltf::Document& ours, const tinygltf::Model& theirs) {
    EXPECT_EQ(ours.scene, theirs.defaultScene);
    ASSERT_EQ(ours.scenes.size(), theirs.scenes.size());
    for (std::size_t i = 0; i < ours.scenes.size(); ++i)
        EXPECT_EQ(ours.scenes[i].nodes, theirs.scenes[i].nodes);
    ASSERT_EQ(ours.nodes.size(), theirs.nodes.size());
    for (std::size_t i = 0; i < ours.nodes.size(); ++i) {
        const gltf::Node& own = ours.nodes[i];
        const tinygltf::Node& their = theirs.nodes[i];
        EXPECT_EQ(std::tie(own.name, own.children, own.mesh, own.camera, own.skin),
                  std::tie(their.name, their.children, their.mesh, their.camera, their.skin));
        EXPECT_EQ(std::tie(own.matrix, own.translation, own.rotation, own.scale),
                  std::tie(their.matrix, their.translation, their.rotation, their.scale));
    }
    ASSERT_EQ(ours.cameras.size(), theirs.cameras.size());
    for (std::size_t i = 0; i < ours.cameras.size(); ++i) {
        const gltf::Camera& own = ours.cameras[i];
        const tinygltf::Camera& their = theirs.cameras[i];
        EXPECT_EQ(std::tie(own.name, own.type), std::tie(their.name, their.type));
        EXPECT_EQ(own.perspective.yfov, their.perspective.yfov);
        EXPECT_EQ(own.perspective.znear, their.perspective.znear);
        EXPECT_EQ(own.perspective.zfar, their.perspective.zfar);
        EXPECT_EQ(own.orthographic.ymag, their.orthographic.ymag);
    }
}

void expect_same_materials(const gltf::Document& ours, const tinygltf::Model& theirs) {
    ASSERT_EQ(ours.materials.size(), theirs.materials.size());
    for (std::size_t i = 0; i < ours.materials.size(); ++i) {
        const gltf::MetallicRoughness& own = ours.materials[i].pbrMetallicRoughness;
        const tinygltf::PbrMetallicRoughness& their = theirs.materials[i].pbrMetallicRoughness;
        EXPECT_EQ(ours.materials[i].name, theirs.materials[i].name);
        EXPECT_EQ(own.baseColorFactor, their.baseColorFactor);
        EXPECT_EQ(std::tie(own.baseColorTexture.index, own.baseColorTexture.texCoord),
                  std::tie(their.baseColorTexture.index, their.baseColorTexture.texCoord));
        EXPECT_EQ(own.baseColorTexture.extensions.size(), their.baseColorTexture.extensions.size());
    }
    ASSERT_EQ(ours.textures.size(), theirs.textures.size());
    for (std::size_t i = 0; i < ours.textures.size(); ++i)
        EXPECT_EQ(std::tie(ours.textures[i].sampler, ours.textures[i].source),
                  std::tie(theirs.textures[i].sampler, theirs.textures[i].source));
    ASSERT_EQ(ours.samplers.size(), theirs.samplers.size());
    for (std::size_t i = 0; i < ours.samplers.size(); ++i) {
        const gltf::Sampler& own = ours.samplers[i];
        const tinygltf::Sampler& their = theirs.samplers[i];
        EXPECT_EQ(std::tie(own.magFilter, own.minFilter, own.wrapS, own.wrapT),
                  std::tie(their.magFilter, their.minFilter, their.wrapS, their.wrapT));
    }
    EXPECT_EQ(ours.images.size(), theirs.images.size());
}

/// tinygltf reads the same files by code of its own.
TEST(GltfModels, AreReadAsTinygltfReadsThem) {
    for (const json& entry : manifest()) {
        const std::string file = entry["file"];
        SCOPED_TRACE(file);
        const GltfModel ours = read_gltf(models / file);
        const tinygltf::Model theirs = tinygltf_model(models / file);
        expect_same_accessors(ours.document, theirs);
        expect_same_meshes(ours.document, theirs);
        expect_same_nodes(ours.document, theirs);
        expect_same_materials(ours.document, theirs);
        EXPECT_EQ(ours.animations, theirs.animations.size());
    }
}

TEST(GltfModels, LoadTheSameBitsTwice) {
    const fs::path file = models / "KayKitDungeonHall" / "KayKitDungeonHall.glb";
    const Loaded first = load_gltf(file), second = load_gltf(file);
    EXPECT_EQ(first.scene.vertices.position_world, second.scene.vertices.position_world);
    EXPECT_EQ(first.scene.triangles, second.scene.triangles);
}

TEST(GltfModels, SayWhatTheyLeaveOut) {
    const Loaded points =
        load_gltf(models / "AssetGenerator_Mesh_PrimitiveMode" / "Mesh_PrimitiveMode_00.gltf");
    EXPECT_EQ(points.scene.notes.at(0), "primitives of points and lines skipped: 1");
    EXPECT_EQ(points.scene.notes.at(1), "no triangles: there is nothing to judge");
}

}  // namespace
}  // namespace zproof
