/// Scenes of zproof's own as files, for renderers that are to be shown them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/common_arguments.h"
#include "program/exit_code.h"
#include "scenes/loaded.h"

namespace zproof {

/// Writes NAME.glb, its textures inside, and NAME.view.json for each name into a new folder, and prints the
/// view files' paths, or, quiet, the folder's. An interrupt ends it after the scene in hand; what was done is
/// written.
ExitCode write_scenes(const std::vector<std::string>& names, const CommonArguments& common,
                      const std::function<Loaded(const std::string&)>& scene_named);

}  // namespace zproof
