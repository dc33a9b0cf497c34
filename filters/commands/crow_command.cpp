#include <iostream>
#include <span>

#include "filters/commands/commands.h"
#include "filters/report/crow_page.h"
#include "filters/study/study.h"
#include "frame/whole_file.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/study_scenes.h"
#include "program/version.h"
#include "program/work_progress.h"
#include "reports/output_folder.h"

namespace zproof {
namespace {

/// Point sampled, mip mapped, summed-area table: Crow's own three.
study::Plan crow_plan(int height) {
    study::Plan plan{.methods = {},
                     .truth = oracle::Reconstruction::nearest,
                     .flicker_steps = 0,
                     .first_row = natural_first_row({.word = "worked", .reason = {}}, height)};
    for (const char* name : {"nearest", "trilinear-gl", "sat-affine"})
        plan.methods.push_back({name, filter_choice(name).texturing});
    return plan;
}

}  // namespace

ExitCode execute(const FiltersCrowArguments& arguments) {
    OutputFolder out{arguments.common.out};
    const Loaded loaded = load({.word = "worked", .reason = {}}, arguments.settings.resolution);
    const study::Plan plan = crow_plan(arguments.settings.resolution.height);
    study::StudyResults results = study::begun(plan);
    results.version = version_number();
    results.compiler = compiler_name();
    std::vector<CrowPicture> pictures;
    note_interrupts();
    WorkProgress progress{std::cerr, progress_of(arguments.common), 1 + study::work_of(plan)};
    const study::ProgressSink progress_sink{
        .begins = [&](const std::string& what, double work) { progress.begin(what, work); },
        .is_shown =
            [&](const std::string& name, const Picture& picture) {
                pictures.push_back({name, picture});
            },
        .wants_to_stop = interrupted};
    study::CrowAnswers answers;
    on_threads(arguments.common.threads, [&] {
        results.views.push_back(study::study_view(loaded.scene, loaded.views.at(0), plan, progress_sink));
        if (interrupted()) return;
        progress.begin("answers");
        answers = study::crow_answers();
    });
    if (interrupted()) return say_interrupted({0, 1}, "page", "written");
    const std::string page = crow_page(results, pictures, answers);
    write_whole_file(out.working() / "crow1984.html", std::as_bytes(std::span{page}));
    const std::filesystem::path place = publish(out, arguments.common);
    progress.say(std::cout, (place / "crow1984.html").string() + "\n");
    return ExitCode::proven;
}

}  // namespace zproof
