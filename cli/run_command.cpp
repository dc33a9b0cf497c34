#include <iostream>

#include "cli/commands.h"
#include "cli/judgement.h"

namespace zproof {

ExitCode execute(const RunArguments& arguments) {
    std::vector<SceneSource> sources = select_scenes(arguments.scenes);
    if (sources.empty()) {
        std::cerr << "zproof: nothing to judge: no .gltf, .glb or .view.json in what was named\n";
        return ExitCode::nothing;
    }
    return judge_and_report(
        {std::move(sources), arguments.parties, arguments.settings, arguments.report, /*only_view=*/""});
}

}  // namespace zproof
