/// The baked scene as a binary glTF: one mesh, world space, triangle i = primitive id i.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/loaded.h"

namespace zproof {

/// The scene alone: positions, normals, uv sets, colours, materials and images. A scene without parts is one
/// primitive, and one without triangles has no mesh. Throws SceneError where the parts leave a triangle out.
std::string glb_bytes(const Scene& scene);

/// Writes them under that name. Throws SceneError where it cannot.
void write_glb_file(const std::filesystem::path& file, const Scene& scene);

/// Writes FOLDER/NAME.glb, and FOLDER/NAME.view.json with the views, so that load_view_file gives back the
/// same bits. Throws SceneError where it cannot write.
void write_glb(const std::filesystem::path& folder, const Loaded& loaded);

}  // namespace zproof
