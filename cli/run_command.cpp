#include <iostream>

#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/judgement.h"

namespace zproof {

ExitCode execute(const RunArguments& arguments) {
    const std::vector<SceneSource> selected = select_scenes(arguments.scenes, arguments.models);
    if (selected.empty()) {
        std::cerr << "zproof: nothing to judge: no .gltf, .glb or .view.json in what was named\n";
        return ExitCode::nothing;
    }
    return judge_and_report({.sources = share_of(selected, arguments.shard),
                             .renderers = arguments.renderers,
                             .settings = arguments.settings,
                             .report = arguments.report,
                             .selection = selection_of(selected, arguments.settings.resolution),
                             .shard = arguments.shard});
}

}  // namespace zproof
