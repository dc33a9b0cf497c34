#include <iostream>

#include "cli/commands.h"
#include "cli/renderers/roster.h"
#include "cli/threads.h"
#include "measure/measure.h"
#include "reports/measurement_report.h"

namespace zproof {
namespace {

/// The renderer as an instrument reads it: any scene, any view.
measure::Renderer subject(const RendererChoice& choice) {
    return {
        .name = name_of(choice),
        .render = [choice](const Scene& scene, const View& view) { return open(choice, scene).render(view); },
        .declared = declared_precision(choice)};
}

}  // namespace

ExitCode execute(const MeasureArguments& arguments) {
    const measure::Renderer renderer = subject(arguments.renderer);
    measure::Measurement measurement;
    on_threads(1, [&] { measurement = measure::measure(renderer); });  // hundreds of pictures, all tiny
    const auto findings = measure::findings(measurement, renderer.declared);
    std::cout << (arguments.format == MeasurementFormat::json ? measurement_json(renderer.name, findings)
                                                              : measurement_table(renderer.name, findings));
    return measure::is_worse(findings) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
