#include <filesystem>

#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/judgement.h"
#include "oracle/convention/stored_frame.h"
#include "program/samples.h"
#include "program/usage_error.h"
#include "renderers/registry.h"

namespace zproof {
namespace {

/// A frame shows one sample.
void require_frames(const CompareArguments& arguments) {
    const std::vector<Sample>& samples = arguments.settings.samples;
    const RendererChoice& candidate = arguments.renderers.candidate;
    if (samples.size() == 1 && is_centre(samples.front()) && has_frame_for_each_sample(candidate))
        throw UsageError{"compare: " + name_of(candidate) +
                         " says {sample}; expected --sample, e.g. --sample standard:4"};
    if (samples.size() == 1) return;
    for (const RendererChoice* choice : {&candidate, &arguments.renderers.reference})
        if (!has_frame_for_each_sample(*choice))
            throw UsageError{"compare: " + name_of(*choice) + " is one frame, and --sample means " +
                             std::to_string(arguments.settings.samples.size()) +
                             "; expected {sample} in its name or in --channels, e.g. frame-{sample}.exr"};
}

}  // namespace

ExitCode execute(const CompareArguments& arguments) {
    require_frames(arguments);
    const RendererChoice chosen =
        at_sample(arguments.renderers.candidate, arguments.settings.samples.front());
    const Resolution size = oracle::stored_frame_size(std::get<StoredFrame>(chosen.who).file,
                                                      declared_convention(chosen), id_channel_of(chosen));
    const SceneSource source = select_scene(arguments.scene, arguments.models);
    return judge_and_report({.sources = {source},
                             .renderers = arguments.renderers,
                             .settings = {.resolution = size, .samples = arguments.settings.samples},
                             .report = arguments.report,
                             .selection = selection_of({source}, size),
                             .views = {arguments.view, ViewChoice::Many::are_refused}});
}

}  // namespace zproof
