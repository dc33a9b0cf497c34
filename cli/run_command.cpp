#include <iostream>
#include <utility>

#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/judgement.h"
#include "cli/run_size.h"
#include "cli/scene_selection.h"
#include "frame/printable.h"
#include "scenes/model_file.h"

namespace zproof {

ExitCode execute(const RunArguments& arguments) {
    const auto [named, passed_over] = select_with_counts(arguments.scenes, arguments.models);
    if (const std::string words = in_words(passed_over);
        !words.empty() && !arguments.report.common.is_quiet())
        std::cerr << "zproof: " << shortened(words, longest_line_bytes - 10) << "\n";
    if (named.empty()) {
        std::cerr << "zproof: nothing to judge: no " << model_endings
                  << " and no .view.json in what was named; export any other model as .glb\n";
        return ExitCode::nothing;
    }
    const std::vector<SceneSource> selected =
        sources_for(arguments.size, arguments.settings.resolution, named);
    Selection selection = selection_of(selected, arguments.settings.resolution);
    selection.passed_over = passed_over;
    return judge_and_report({.sources = share_of(selected, arguments.shard),
                             .renderers = arguments.renderers,
                             .settings = arguments.settings,
                             .report = arguments.report,
                             .selection = std::move(selection),
                             .shard = arguments.shard});
}

}  // namespace zproof
