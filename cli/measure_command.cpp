#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/threads.h"
#include "cli/usage_error.h"
#include "measure/measure.h"
#include "rasterizer/rasterizer.h"
#include "reports/measurement_report.h"

namespace zproof {
namespace {

using measure::Renderer;

/// Every renderer that can be measured. A new one is a line here: a name, a function and a promise.
std::vector<Renderer> renderers() {
    return {{.name = "zproof", .render = rasterizer::render, .declared = rasterizer::precision()}};
}

Renderer renderer_called(const std::string& name) {
    std::string known;
    for (Renderer& renderer : renderers()) {
        if (renderer.name == name) return std::move(renderer);
        known += (known.empty() ? "'" : ", '") + renderer.name + "'";
    }
    throw UsageError{"measure: no renderer '" + name + "'; there is " + known +
                     " (see: zproof measure --help)"};
}

}  // namespace

ExitCode execute(const MeasureArguments& arguments) {
    const Renderer renderer = renderer_called(arguments.renderer);
    measure::Measurement measurement;
    on_threads(1, [&] { measurement = measure::measure(renderer); });  // hundreds of pictures, all tiny
    const auto findings = measure::findings(measurement, renderer.declared);
    std::cout << (arguments.format == MeasurementFormat::json ? measurement_json(renderer.name, findings)
                                                              : measurement_table(renderer.name, findings));
    return measure::is_worse(findings) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
