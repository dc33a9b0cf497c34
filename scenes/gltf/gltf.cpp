#include "scenes/gltf/gltf.h"

#include "scenes/frame_all.h"
#include "scenes/gltf/bake.h"
#include "scenes/gltf/camera.h"
#include "scenes/gltf/materials.h"
#include "scenes/gltf/model.h"
#include "scenes/gltf/nodes.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

Scene bake(GltfModel& model, const std::vector<PlacedNode>& nodes) {
    Scene scene;
    scene.name = model.file.stem().string();
    scene.notes = std::move(model.notes);
    bake_materials(model, scene);
    bake_meshes(model, nodes, scene);
    drop_textures_without_uv(scene);
    return scene;
}

void add_views(const GltfModel& model, const std::vector<PlacedNode>& nodes, const glm::ivec2& size,
               Loaded& loaded) {
    try {
        bake_cameras(model, nodes, size, loaded);
        if (loaded.views.empty())
            loaded.views.push_back(
                {"frame-all", frame_all(loaded.scene, static_cast<double>(size.x) / size.y), size.x, size.y});
    } catch (const SceneError& error) {
        refuse(model.file, "cameras", error.what());
    }
}

}  // namespace

Scene load_gltf_scene(const std::filesystem::path& file) {
    GltfModel model = read_gltf(file);
    return bake(model, placed_nodes(model));
}

Loaded load_gltf(const std::filesystem::path& file, int width, int height) {
    GltfModel model = read_gltf(file);
    const std::vector<PlacedNode> nodes = placed_nodes(model);
    Loaded loaded{bake(model, nodes), {}};
    add_views(model, nodes, {width, height}, loaded);
    return loaded;
}

}  // namespace zproof
