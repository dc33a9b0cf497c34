/// What the judge said of one view, in the shape that the reports show.
#pragma once

#include <span>
#include <string>

#include "cli/gate/gate.h"
#include "cli/labelled_candidate.h"
#include "compare/verdict.h"
#include "compare/waivers/coverage.h"
#include "program/scene_selection.h"
#include "renderers/choice.h"
#include "reports/results.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// Scene and view, told of the command that explains one of its pixels.
struct ViewContext {
    const SceneSource& source;
    const Scene& scene;
    const std::string& scene_sha256;
    const View& view;
    const ChosenRenderers& renderers;
};

/// The command that explains what this candidate said at a pixel of this view, quoted for a shell.
std::string explain_command_for(const ViewContext& context, const RendererChoice& candidate, int x, int y);

/// The command that judges this scene once more: the one that was typed where it names a frame.
std::string judging_command_for(const SceneSource& source, const ChosenRenderers& renderers,
                                Resolution resolution, const std::string& typed);

/// Everything but times and folder. A view whose defects are all waived is proven. `told`: those of the
/// verdict's findings that are told of, the worst first.
ViewResult to_view_result(const ViewContext& context, const Verdict& verdict, std::span<const Finding> told,
                          const Gate& gate, const CandidateFrame& candidate);

/// What the judge said of an oracle.
OracleResult to_oracle_result(const ViewContext& context, const RendererChoice& oracle,
                              const Verdict& verdict);

/// A scene of which nothing was judged: why stands in the message.
ViewResult unjudged(const SceneSource& source, Outcome outcome, const std::string& message);

}  // namespace zproof
