#pragma once

#include <filesystem>
#include <vector>

#include "scenes/import/calibrated_camera.h"

namespace zproof {

/// Throws SceneError where there is no view, or two of one name.
void require_unique_names(const std::filesystem::path& file, const std::vector<ImportedView>& views);

}  // namespace zproof
