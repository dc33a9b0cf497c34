/// How much a run does where nobody says it in detail.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/scene_selection.h"

namespace zproof {

enum class RunSize {
    quick,     ///< small pictures, Embree alone: for a hook that runs before each commit
    usual,     ///< 1920 x 1080, POV-Ray at a sample of the pixels
    thorough,  ///< further resolutions, every oracle at every pixel: for the night
};

/// The resolution of a run of that size; `usual` is what it has otherwise.
Resolution resolution_for(RunSize size, Resolution usual);

/// The oracles of a run that names none; nothing: the usual ones.
std::optional<std::vector<std::string>> oracles_for(RunSize size);

/// The scenes; those that have a usual size have it, unless the run is thorough or has a resolution of its
/// own. A thorough run has each once more at further resolutions, as "room.641x359", and the suite's scenes
/// that are its own. View files, random scenes and some of the suite state their sizes and stand once. Places
/// are counted anew.
std::vector<SceneSource> sources_for(RunSize size, Resolution resolution,
                                     const std::vector<SceneSource>& named);

}  // namespace zproof
