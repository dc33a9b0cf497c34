#include "scenes/gltf/gltf.h"

#include "scenes/gltf/bake.h"
#include "scenes/polygon_mesh.h"
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

}  // namespace

Scene load_gltf_scene(const std::filesystem::path& file) {
    GltfModel model = read_gltf(file);
    return bake(model, placed_nodes(model));
}

Loaded load_gltf(const std::filesystem::path& file, int width, int height) {
    GltfModel model = read_gltf(file);
    const std::vector<PlacedNode> nodes = placed_nodes(model);
    Loaded loaded{bake(model, nodes), {}};
    try {
        bake_cameras(model, nodes, {width, height}, loaded);
    } catch (const SceneError& error) {
        refuse(file, "cameras", error.what());
    }
    if (!loaded.views.empty()) return loaded;
    return with_default_view(file, std::move(loaded.scene), width, height);
}

}  // namespace zproof
