/// View files: JSON that adds cameras, resolution and settings to a glTF (docs/view-file.md).
#pragma once

#include <filesystem>

#include "scenes/loaded.h"

namespace zproof {

/// Loads the glTF that the view file names (a path inside the view file's folder) and the views it lists.
/// Throws SceneError, naming the file and the JSON pointer, for anything missing, unknown or out of range.
Loaded load_view_file(const std::filesystem::path& file);

}  // namespace zproof
