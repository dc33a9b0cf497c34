#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/renderers/registry.h"
#include "cli/scene_selection.h"
#include "cli/threads.h"
#include "cli/usage_error.h"
#include "compare/explanation/explain.h"

namespace zproof {
namespace {

const View& view_named(const std::string& name, const Loaded& loaded) {
    if (name.empty()) return loaded.views.front();
    const auto view = std::ranges::find(loaded.views, name, &View::name);
    if (view == loaded.views.end())
        throw UsageError{"--view " + name + ": " + loaded.scene.name + " has the views " +
                         names_of(loaded.views)};
    return *view;
}

void require_inside(const ExplainArguments& arguments, const View& view) {
    if (arguments.x < view.width && arguments.y < view.height) return;
    throw UsageError{"pixel (" + std::to_string(arguments.x) + ", " + std::to_string(arguments.y) +
                     ") lies outside the view '" + view.name + "', which is " + std::to_string(view.width) +
                     " x " + std::to_string(view.height) + "; see --width, --height"};
}

PixelExplanation story_of(const ExplainArguments& arguments, const Scene& scene, const View& view) {
    const Renderer ours = open(arguments.renderers.candidate, scene),
                   theirs = open(arguments.renderers.reference, scene);
    const Frame candidate = ours.render(view), reference = theirs.render(view);
    return explain(scene, view, {candidate, ours.precision}, {reference, theirs.precision},
                   {arguments.x, arguments.y});
}

}  // namespace

ExitCode execute(const ExplainArguments& arguments) {
    const SceneSource source = select_scene(arguments.scene, arguments.models);
    const Loaded loaded = load(source, arguments.settings.resolution);
    const View& view = view_named(arguments.view, loaded);
    require_inside(arguments, view);
    if (loaded.scene.triangles.empty()) {
        std::cerr << "zproof: " << source.name << ": the scene has no triangles, nothing to explain\n";
        return ExitCode::nothing;
    }
    PixelExplanation story;
    on_threads(arguments.settings.threads, [&] { story = story_of(arguments, loaded.scene, view); });
    std::cout << in_words(loaded.scene, story);
    return passes(story.finding.verdict) ? ExitCode::proven : ExitCode::defect;
}

}  // namespace zproof
