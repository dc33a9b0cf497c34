/// What a run judges.
#pragma once

#include <vector>

#include "cli/arguments.h"
#include "program/scene_selection.h"
#include "reports/results.h"

namespace zproof {

/// The scenes of a run, and what its shards have in common.
struct SelectedScenes {
    std::vector<SceneSource> sources;
    Selection selection;
};

/// Throws SceneError for a word that means no scene.
SelectedScenes selected_scenes(const RunArguments& run);

}  // namespace zproof
