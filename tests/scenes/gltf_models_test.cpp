/// Every valid model of the shared collection against the facts that its manifest states.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "scenes/gltf/gltf.h"
#include "scenes/gltf/model.h"
#include "scenes/gltf/nodes.h"

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
        mirrored += model.gltf.nodes[static_cast<std::size_t>(placed.node)].mesh >= 0 &&
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
