/// View files: JSON that adds cameras, resolution and settings to a glTF (docs/view-file.md).
#pragma once

#include <filesystem>

#include "scenes/loaded.h"

namespace zproof {

/// Loads the glTF that the view file names and the views it lists. The glTF lies beneath the view file's
/// folder, or beneath that of models, where one is named. Throws SceneError, naming the file and the JSON
/// pointer, for anything missing, unknown or out of range.
Loaded load_view_file(const std::filesystem::path& file, const std::filesystem::path& models = {});

}  // namespace zproof
