#include <CLI/CLI.hpp>
#include <algorithm>

#include "lessons/cost/report.h"
#include "lessons/study.h"

namespace zproof {
namespace {

document::Document perform_cost_study(const StudyTask& task) {
    const int repeats = task.arguments.cost.repeats;
    task.progress.expect_more(study::cost::units_of_model());
    const study::cost::Model model =
        study::cost::fitted_model(repeats, [&](const std::string& what) { task.progress.begin(what); });
    document::Document document = cost_document(model);
    std::vector<study::cost::Prediction> predictions;
    std::vector<document::Section> optimizations;
    each_view(task, [&](const StudiedView& one) {
        task.progress.begin("prediction");
        predictions.push_back(study::cost::predict(model, one.scene, one.view, repeats));
        task.progress.begin("optimizations");
        optimizations.push_back(
            optimization_section(study::cost::study_optimizations(one.scene, one.view, repeats), one.stem));
    });
    std::ranges::move(prediction_sections(predictions), std::back_inserter(document.sections));
    std::ranges::move(optimizations, std::back_inserter(document.sections));
    return document;
}

void add_cost_options(CLI::App& app, StudyArguments& arguments) {
    app.add_option("--repeats", arguments.cost.repeats, "measured runs for each time")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

}  // namespace

Study cost_study() {
    return {.name = "cost",
            .purpose = "what a z-buffer's time is made of, and what the visibility optimizations save",
            .subjects = {"closed_surfaces", "room", "deep_overdraw"},
            .resolution = {960, 540},
            .units_per_view = 2,
            .add_options = add_cost_options,
            .perform = perform_cost_study};
}

}  // namespace zproof
