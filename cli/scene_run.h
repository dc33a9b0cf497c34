/// All work on one scene: load, ask the reference, render, judge, write the evidence.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/early_end.h"
#include "cli/gate/gate.h"
#include "cli/outcome_code.h"
#include "cli/progress.h"
#include "oracle/reference_cache.h"
#include "program/folder_names.h"
#include "program/scene_selection.h"
#include "renderers/choice.h"
#include "reports/results.h"
#include "reports/run_causes.h"

namespace zproof {

/// Which views of a scene are judged.
struct ViewChoice {
    enum class Many { are_judged, are_refused };
    std::string name = "";  ///< empty: all of them
    Many many = Many::are_judged;
};

/// What the scenes of one run share.
struct RunConfig {
    const ChosenRenderers& renderers;
    const RenderSettings& settings;
    const ReportArguments& report;
    const ViewChoice& views;
    const Gate& gate;
    std::filesystem::path run_folder;  ///< evidence goes below it, into scenes/
    FolderNames& names;
    Progress& progress;
    EarlyEnd& early_end;
    CauseVote& causes;
    bool shows_every_view;  ///< does a view without evidence leave what the page shows of it?
    oracle::ReferenceCache* reference_cache;  ///< nothing: reference frames are not kept
};

/// The view's projection, where it is none of those that the renderer has.
std::string refused_projection(const Projections& has, const Camera& camera);

/// Stands in for a scene that was not begun, since the run ended early or was interrupted.
ViewResult left_out(const SceneSource& source, const EarlyEnd& early_end);

/// Stands in for a scene that a fault of zproof's own kept from being judged: how it ended, at which stage
/// (empty: none had begun), and the command that shows it again.
ViewResult ended_by_fault(const SceneSource& source, const RunConfig& config, const std::string& how,
                          const std::string& stage);

/// What came of one scene.
struct SceneReport {
    std::vector<ViewResult> views;  ///< at least one; an unreadable scene and one without triangles say so,
                                    ///< and so does each view that was left unjudged
    Ending ending = Ending::complete;
};

/// Judges the scene's views one by one and tells of each; frames are dropped after each. Uses the surrounding
/// tbb::task_arena. Throws FrameError or ReportError where evidence cannot be written, UsageError where there
/// is no such view, or more than the one that may be.
SceneReport run_scene(const SceneSource& source, const RunConfig& config);

}  // namespace zproof
