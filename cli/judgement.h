/// The main job: judge scenes and write the reports.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/scene_run.h"
#include "program/exit_code.h"
#include "program/scene_selection.h"

namespace zproof {

struct RunRequest {
    std::vector<SceneSource> sources;
    const ChosenRenderers& renderers;
    RenderSettings settings;
    const ReportArguments& report;
    Selection selection;
    Shard shard{};
    ShardStatus shard_status = ShardStatus::is_the_verdict;
    oracle::ReferenceCacheChoice reference_cache{};
    EarlyEndRule early_end{};
    ViewChoice views{};  ///< of every scene
};

/// Writes results.json, the reports that are asked for and the evidence, and prints what the report arguments
/// ask for. Throws std::runtime_error, before any work, where a renderer that is needed cannot be asked on
/// this machine.
ExitCode judge_and_report(const RunRequest& request);

}  // namespace zproof
