#include "cli/selected_scenes.h"

#include <algorithm>
#include <utility>

#include "cli/gate/shard.h"
#include "cli/run_size.h"

namespace zproof {

namespace {

/// The views of an earlier run that failed there, or stand for a scene that did.
std::vector<ViewResult> failed_views(const std::filesystem::path& results) {
    std::vector<ViewResult> views = read_results(results).views;
    std::erase_if(views, [](const ViewResult& view) { return !failed(view); });
    return views;
}

/// Words that mean their scenes. In a thorough run the suite's "room" is "room.641x359", too.
std::vector<std::string> words_for(const std::vector<ViewResult>& views) {
    std::vector<std::string> words;
    for (const ViewResult& view : views)
        words.push_back(view.source == "suite" ? view.scene.substr(0, view.scene.find('.')) : view.source);
    return words;
}

bool is_of(const ViewResult& view, const SceneSource& source) {
    return view.source == source.origin &&
           (source.kind != SceneSource::Kind::suite || view.scene == source.name);
}

void leave_only(const std::vector<ViewResult>& views, std::vector<SceneSource>& sources) {
    for (SceneSource& source : sources)
        for (const ViewResult& view : views)
            if (is_of(view, source)) source.share.only.push_back(view.view);
    std::erase_if(sources, [](const SceneSource& source) { return source.share.only.empty(); });
    for (SceneSource& source : sources)
        if (std::ranges::count(source.share.only, "") > 0)
            source.share.only.clear();  // the whole scene failed
}

}  // namespace

SelectedScenes selected_scenes(const RunArguments& run) {
    std::vector<ViewResult> failed;
    if (!run.only_failed.empty()) failed = failed_views(run.only_failed);
    auto [named, passed_over] =
        select_with_counts(run.scenes.empty() ? words_for(failed) : run.scenes, run.models);
    SelectedScenes selected{sources_for(run.size, run.settings.resolution, named), {}};
    if (!run.only_failed.empty()) leave_only(failed, selected.sources);
    selected.selection = selection_of(selected.sources, run.settings.resolution);
    selected.selection.passed_over = std::move(passed_over);
    return selected;
}

}  // namespace zproof
