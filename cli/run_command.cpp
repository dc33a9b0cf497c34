#include <iostream>
#include <utility>

#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/judgement.h"
#include "cli/plan/planned_run.h"
#include "cli/selected_scenes.h"
#include "frame/printable.h"
#include "scenes/model_file.h"

namespace zproof {

ExitCode execute(const RunArguments& arguments) {
    if (!arguments.plan.empty()) return run_planned(arguments);
    SelectedScenes selected = selected_scenes(arguments);
    if (const std::string words = in_words(selected.selection.passed_over);
        !words.empty() && !arguments.report.common.is_quiet())
        std::cerr << "zproof: " << shortened(words, longest_line_bytes - 10) << "\n";
    if (selected.sources.empty() && !arguments.only_failed.empty()) {
        std::cerr << "zproof: nothing to judge: no view of what was named failed in "
                  << one_line(arguments.only_failed.string()) << "\n";
        return ExitCode::nothing;
    }
    if (selected.sources.empty()) {
        std::cerr << "zproof: nothing to judge: no " << model_endings
                  << " and no .view.json in what was named; export any other model as .glb\n";
        return ExitCode::nothing;
    }
    return judge_and_report({.sources = share_of(std::move(selected.sources), arguments.shard),
                             .renderers = arguments.renderers,
                             .settings = arguments.settings,
                             .report = arguments.report,
                             .selection = std::move(selected.selection),
                             .shard = arguments.shard,
                             .shard_status = arguments.shard_status,
                             .reference_cache = arguments.reference_cache,
                             .early_end = arguments.early_end});
}

}  // namespace zproof
