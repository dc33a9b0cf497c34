/// Wavefront OBJ into a baked scene.
#pragma once

#include <filesystem>

#include "scenes/scene.h"

namespace zproof {

/// Faces in file order, polygons as fans from their first corner; docs/scenes.md has the rest. Throws
/// SceneError, naming the line.
Scene load_obj_scene(const std::filesystem::path& file);

}  // namespace zproof
