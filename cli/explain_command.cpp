#include <iostream>

#include "cli/commands.h"
#include "cli/labelled_candidate.h"
#include "cli/memory.h"
#include "compare/explanation/explain.h"
#include "frame/number_text.h"
#include "frame/printable.h"
#include "program/common_arguments.h"
#include "program/samples.h"
#include "program/scene_selection.h"
#include "program/usage_error.h"
#include "renderers/registry.h"
#include "reports/notes.h"
#include "scenes/judged_ranges.h"

namespace zproof {
namespace {

View asked_view(const ExplainArguments& arguments, const Loaded& loaded) {
    const std::vector<Sample>& samples = arguments.settings.samples;
    if (samples.size() != 1)
        throw UsageError{"explain: --sample means " + std::to_string(samples.size()) +
                         " places; expected one, e.g. standard:" + std::to_string(samples.size()) + ":0"};
    return at_samples({views_named(loaded, arguments.view).front()}, samples).front();
}

void require_inside(const ExplainArguments& arguments, const View& view) {
    if (arguments.x < view.width && arguments.y < view.height) return;
    throw UsageError{"pixel (" + std::to_string(arguments.x) + ", " + std::to_string(arguments.y) +
                     ") lies outside the view '" + view.name + "', which is " +
                     size_text(view.width, view.height) + "; see --width, --height"};
}

/// The story of one pixel, ready to be told.
struct Story {
    std::string text;
    std::string of_label;  ///< empty where the candidate names triangles
    PixelClass verdict = PixelClass::agree;
};

Story story_of(const ExplainArguments& arguments, const Scene& scene, const View& view) {
    const Renderer ours = open(arguments.renderers.candidate, scene),
                   theirs = open(arguments.renderers.reference, scene);
    const Frame reference = theirs.render(view);
    const CandidateFrame candidate =
        candidate_frame(scene, view, ours, ours.render(view), {reference, theirs.precision});
    const PixelExplanation story = explain(scene, view, {candidate.frame, ours.precision},
                                           {reference, theirs.precision}, {arguments.x, arguments.y});
    return {in_words(scene, story), candidate.label_sentence(arguments.x, arguments.y),
            story.finding.verdict};
}

}  // namespace

ExitCode execute(const ExplainArguments& arguments) {
    require_program(arguments.renderers.candidate);
    const SceneSource source = select_scene(arguments.scene, arguments.models);
    const Loaded loaded = load(source, arguments.settings.resolution);
    if (!arguments.common.is_quiet()) std::cerr << note_lines(source.name, loaded.scene.notes);
    const View view = asked_view(arguments, loaded);
    require_inside(arguments, view);
    require_judged(view);
    require_memory({view.width, view.height});
    if (loaded.scene.triangles.empty()) {
        std::cerr << "zproof: " << one_line(source.name)
                  << ": the scene has no triangles, nothing to explain\n";
        return ExitCode::nothing;
    }
    Story story;
    on_threads(arguments.common.threads, [&] { story = story_of(arguments, loaded.scene, view); });
    if (arguments.common.is_quiet()) story = {first_line(story.text), "", story.verdict};
    std::cout << printable(story.text);
    if (!story.of_label.empty()) std::cout << one_line(story.of_label.substr(2)) << '\n';
    return passes(story.verdict) ? ExitCode::proven : ExitCode::defect;
}

}  // namespace zproof
