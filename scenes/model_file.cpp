#include "scenes/model_file.h"

#include "scenes/gltf/gltf.h"
#include "scenes/polygon_mesh.h"

namespace zproof {

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

bool is_model(const std::filesystem::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".gltf" || ending == ".glb" || ending == ".obj" || ending == ".ply";
}

Loaded load_model(const std::filesystem::path& file, int width, int height) {
    const std::string ending = ending_of(file);
    if (ending == ".obj" || ending == ".ply")
        return with_default_view(file, load_model_scene(file), width, height);
    return load_gltf(file, width, height);
}

Scene load_model_scene(const std::filesystem::path& file) {
    const std::string ending = ending_of(file);
    if (ending == ".obj") return load_obj_scene(file);
    return ending == ".ply" ? load_ply_scene(file) : load_gltf_scene(file);
}

}  // namespace zproof
