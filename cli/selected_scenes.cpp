#include "cli/selected_scenes.h"

#include <utility>

#include "cli/gate/shard.h"
#include "cli/run_size.h"

namespace zproof {

SelectedScenes selected_scenes(const RunArguments& run) {
    auto [named, passed_over] = select_with_counts(run.scenes, run.models);
    SelectedScenes selected{sources_for(run.size, run.settings.resolution, named), {}};
    selected.selection = selection_of(selected.sources, run.settings.resolution);
    selected.selection.passed_over = std::move(passed_over);
    return selected;
}

}  // namespace zproof
