#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/memory.h"
#include "frame/precision_text.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/scene_selection.h"
#include "program/usage_error.h"
#include "program/version.h"
#include "program/work_progress.h"
#include "renderers/registry.h"
#include "reports/fit/fit_report.h"
#include "reports/notes.h"
#include "reports/output_folder.h"
#include "reports/pages/folder.h"
#include "reports/pages/writers.h"
#include "scenes/judged_ranges.h"

namespace zproof {
namespace {

/// A stored frame has the size of its own, and stands for every view's.
Resolution resolution_of(const FitArguments& arguments) {
    const auto* stored = std::get_if<StoredFrame>(&arguments.renderer.who);
    return stored ? frame_size(stored->file) : arguments.settings.resolution;
}

/// The views that are fitted: of a stored frame one.
std::vector<View> fitted_views(const FitArguments& arguments, const Loaded& loaded) {
    const bool is_stored = std::holds_alternative<StoredFrame>(arguments.renderer.who);
    if (arguments.view.empty() && is_stored && loaded.views.size() > 1)
        throw UsageError{"fit: " + loaded.scene.name + " has the views " + names_of(loaded.views) +
                         "; say which with --view"};
    return views_named(loaded, arguments.view);
}

/// How many views were asked for, and what was found of them before an interrupt.
struct Fitted {
    std::vector<FittedView> views;
    Share share{0, 0};
    NoteKinds notes{};
};

void fit_scene(const FitArguments& arguments, const SceneSource& source, WorkProgress& progress,
               Fitted& fitted) {
    const Loaded loaded = load(source, resolution_of(arguments));
    fitted.notes.add(source.name, loaded.scene.notes);
    if (loaded.scene.triangles.empty()) {
        progress.say(std::cerr, "zproof: " + source.name + ": the scene has no triangles, nothing to fit\n");
        return;
    }
    const std::vector<View> views = fitted_views(arguments, loaded);
    fitted.share.all += views.size();
    progress.expect_more(double(views.size()) - 1);
    const Renderer renderer = open(arguments.renderer, loaded.scene);
    for (const View& view : views) {
        if (interrupted()) return;
        progress.begin(source.name + " / " + view.name);
        require_judged(view);
        require_memory({view.width, view.height});
        fitted.views.push_back(
            {source.name, view.name, measure::fit(loaded.scene, view, renderer.render(view))});
        ++fitted.share.done;
    }
}

Fitted fit_all(const FitArguments& arguments, const std::vector<SceneSource>& sources) {
    Fitted fitted;
    WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(sources.size())};
    on_threads(arguments.common.threads, [&] {
        for (std::size_t i = 0; i < sources.size(); ++i) {
            if (interrupted()) fitted.share.scenes_left = sources.size() - i;
            if (interrupted()) return;
            fit_scene(arguments, sources[i], progress, fitted);
        }
    });
    return fitted;
}

void write(const FitArguments& arguments, const std::vector<FittedView>& views, Completeness completeness) {
    const std::string renderer = name_of(arguments.renderer);
    document::Document document = fit_document(renderer, views);
    document.command = arguments.typed;
    document.version = version_number();
    OutputFolder out{arguments.common.out};
    document::write_document(out.working(), document);
    write_whole_file(out.working() / "fit.json", fit_json(renderer, views));
    write_whole_file(out.working() / "precision.json", precision_to_json(promise_of(views)) + "\n");
    const std::filesystem::path place = publish(out, arguments.common, completeness);
    if (!arguments.common.is_quiet()) std::cout << document::terminal_text(document) << "\n";
    std::cout << "fit: " << one_line((place / "study.html").string()) << "\n";
}

}  // namespace

ExitCode execute(const FitArguments& arguments) {
    require_program(arguments.renderer);
    const std::vector<SceneSource> sources = select_scenes(arguments.scenes);
    note_interrupts();
    const Fitted fitted = fit_all(arguments, sources);
    if (!arguments.common.is_quiet()) std::cerr << fitted.notes.lines();
    const bool all_done = fitted.share.done == fitted.share.all && fitted.share.scenes_left == 0;
    if (!fitted.views.empty())
        write(arguments, fitted.views, all_done ? Completeness::full : Completeness::partial);
    if (interrupted() && !all_done) return say_interrupted(fitted.share, "view", "fitted and written");
    if (fitted.views.empty()) {
        std::cerr << "zproof: nothing to fit\n";
        return ExitCode::nothing;
    }
    return explains_all(fitted.views) ? ExitCode::proven : ExitCode::defect;
}

}  // namespace zproof
