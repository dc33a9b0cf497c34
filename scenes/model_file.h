/// Model files of every kind that is read, by their ending: .gltf, .glb, .obj, .ply.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/loaded.h"

namespace zproof {

/// ".gltf, .glb, .obj or .ply", for messages.
inline constexpr const char* model_endings = ".gltf, .glb, .obj or .ply";

/// A file's ending in lower case, with its dot.
std::string ending_of(const std::filesystem::path& file);

/// Whether the ending, in letters of any case, is a model's.
bool is_model(const std::filesystem::path& file);

/// Loads the model with its cameras; a view "frame-all" of width x height where it has none. What ends in no
/// model's ending is read as glTF. Throws SceneError (docs/scenes.md).
Loaded load_model(const std::filesystem::path& file, int width, int height);

/// The scene without cameras, for callers that bring their own views.
Scene load_model_scene(const std::filesystem::path& file);

}  // namespace zproof
