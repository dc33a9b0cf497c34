#include <iostream>
#include <map>

#include "cli/commands.h"
#include "cli/threads.h"
#include "cli/usage_error.h"
#include "measure/measure.h"
#include "oracle/opengl.h"
#include "rasterizer/rasterizer.h"
#include "reports/measurement_report.h"

namespace zproof {
namespace {

using measure::Renderer;

/// A scene is handed to the driver anew for every probe, so that scenes need not be told apart.
Renderer opengl_renderer() {
    const auto render = [](const Scene& scene, const View& view) {
        return oracle::OpenGl(scene).render(view);
    };
    return {.name = "opengl", .render = render, .declared = oracle::opengl_precision()};
}

/// Every renderer that can be measured, by name. A new one is a line here.
const std::map<std::string, Renderer (*)()>& renderers() {
    static const std::map<std::string, Renderer (*)()> all{
        {"zproof",
         [] {
             return Renderer{
                 .name = "zproof", .render = rasterizer::render, .declared = rasterizer::precision()};
         }},
        {"opengl", opengl_renderer}};
    return all;
}

Renderer renderer_called(const std::string& name) {
    std::string known;
    for (const auto& [known_name, made] : renderers()) {
        if (known_name == name) return made();
        known += (known.empty() ? "'" : ", '") + known_name + "'";
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
