#include <filesystem>

#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/judgement.h"
#include "cli/renderers/registry.h"
#include "cli/usage_error.h"
#include "oracle/convention/stored_frame.h"

namespace zproof {
namespace {

/// A frame is of one view: where the scene has several, somebody must say which.
std::string view_meant(const CompareArguments& arguments, const SceneSource& source, Resolution size) {
    if (!arguments.view.empty()) return arguments.view;
    const std::vector<View> views = load(source, size).views;
    if (views.size() == 1) return views.front().name;
    throw UsageError{"compare: " + source.name + " has the views " + names_of(views) +
                     "; say which with --view"};
}

}  // namespace

ExitCode execute(const CompareArguments& arguments) {
    const auto& candidate = std::get<StoredFrame>(arguments.renderers.candidate.who);
    const RendererChoice& chosen = arguments.renderers.candidate;
    const Resolution size =
        oracle::stored_frame_size(candidate.file, declared_convention(chosen), id_channel_of(chosen));
    const SceneSource source = select_scene(arguments.scene, arguments.models);
    return judge_and_report({.sources = {source},
                             .renderers = arguments.renderers,
                             .settings = {.resolution = size, .threads = arguments.threads},
                             .report = arguments.report,
                             .selection = selection_of({source}, size),
                             .only_view = view_meant(arguments, source, size)});
}

}  // namespace zproof
