/// glTF 2.0 (.gltf, .glb) into a baked scene, trusting nothing in the file.
#pragma once

#include <filesystem>

#include "scenes/loaded.h"

namespace zproof {

/// Loads the default scene (or scene 0). Every camera node becomes a view of width x height named after it; a
/// scene without a camera gets one named "frame-all" that frames its bounds. Throws SceneError for whatever
/// is not usable (docs/scenes.md); never reads outside the file's folder.
Loaded load_gltf(const std::filesystem::path& file, int width = 1920, int height = 1080);

/// The scene without its cameras, for callers that bring their own views.
Scene load_gltf_scene(const std::filesystem::path& file);

}  // namespace zproof
