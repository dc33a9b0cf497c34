#include <stdexcept>
#include <utility>

#include "cli/commands.h"
#include "cli/judgement.h"
#include "cli/measurement_run.h"
#include "cli/outcome_code.h"
#include "cli/selected_scenes.h"
#include "cli/texture_promises.h"
#include "program/interrupt.h"
#include "renderers/registry.h"
#include "reports/conformance_report.h"

namespace zproof {
namespace {

/// The suite as a quick run has it, then the random scenes.
RunArguments run_of(const RandomChoice& random) {
    RunArguments run;
    run.size = RunSize::quick;
    run.scenes = random.words();
    run.scenes.insert(run.scenes.begin(), "suite");
    run.settings.resolution = resolution_for(run.size, run.settings.resolution);
    return run;
}

/// Measures the device, or says why that cannot be.
Foreword foreword_of(const ConformanceArguments& arguments, const Results& results) {
    MeasuredPromises promises;
    ExitCode code = ExitCode::proven;
    try {
        const measure::Renderer renderer = measured_renderer(arguments.renderer);
        const auto [measurement, instruments] = measured(renderer, arguments.report.common);
        promises.findings = measure::findings(measurement, renderer.declared);
        if (measure::is_worse(promises.findings)) code = ExitCode::defect;
        if (instruments.done < instruments.all) {
            promises.refusal = "interrupted";
            code = say_interrupted(instruments, "instrument", "read");
        }
    } catch (const std::runtime_error& e) {
        promises.refusal = e.what();
        code = ExitCode::cannot_judge;
    }
    if (!interrupted()) promises.textures = texture_promises(arguments.renderer, arguments.report.common);
    for (const TexturePromise& texture : promises.textures)
        code = worst_of({code, !texture.refusal.empty() ? ExitCode::cannot_judge
                               : texture.is_broken      ? ExitCode::defect
                                                        : ExitCode::proven});
    return {conformance_document(results, promises), "conformance.json", code};
}

}  // namespace

ExitCode execute(const ConformanceArguments& arguments) {
    require_program(arguments.renderer);
    const RunArguments run = run_of(arguments.random);
    SelectedScenes selected = selected_scenes(run);
    ChosenRenderers renderers;
    renderers.candidate = arguments.renderer;
    return judge_and_report(
        {.sources = std::move(selected.sources),
         .renderers = renderers,
         .settings = run.settings,
         .report = arguments.report,
         .selection = std::move(selected.selection),
         .foreword = [&](const Results& results) { return foreword_of(arguments, results); }});
}

}  // namespace zproof
