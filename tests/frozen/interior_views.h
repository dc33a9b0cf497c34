/// Views from within models: those of the file interior_views.json beside them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/view.h"

namespace zproof::frozen {

/// By the model's place in the folder; none where the folder has no such file.
std::map<std::string, std::vector<View>> interior_views(const std::filesystem::path& folder, Resolution size);

}  // namespace zproof::frozen
