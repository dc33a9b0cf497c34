/// The main job: judge scenes and write the reports.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/scene_run.h"
#include "program/exit_code.h"
#include "program/scene_selection.h"
#include "reports/pages/document.h"

namespace zproof {

/// What the page tells before the views, and what it means for the exit status.
struct Foreword {
    document::Document document;
    std::string file;                  ///< for the document as JSON
    ExitCode code = ExitCode::proven;  ///< interrupted: the folder is a partial one
};

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
    /// Made once all is judged. Empty: there is none. Where there is one, it is
    /// printed in the place of the table of views.
    std::function<Foreword(const Results&)> foreword{};
};

/// Writes results.json, the reports that are asked for and the evidence, and prints what the report arguments
/// ask for. Throws std::runtime_error, before any work, where a renderer that is needed cannot be asked on
/// this machine.
ExitCode judge_and_report(const RunRequest& request);

}  // namespace zproof
