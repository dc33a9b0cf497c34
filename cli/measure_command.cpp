#include <array>
#include <iostream>

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

Renderer zproof_renderer() {
    return {.name = "zproof", .render = rasterizer::render, .declared = rasterizer::precision()};
}

Renderer opengl_renderer() {
    const oracle::OpenGlDriver driver;
    const auto render = [driver](const Scene& scene, const View& view) { return driver.render(scene, view); };
    return {.name = "opengl", .render = render, .declared = driver.precision()};
}

/// A renderer is opened only where it is asked for: its driver may be missing.
struct Known {
    const char* name;
    Renderer (*open)();
};

/// Every renderer that can be measured. A new one is a line here: a name, a function and a promise.
constexpr std::array<Known, 2> renderers{Known{"zproof", zproof_renderer}, Known{"opengl", opengl_renderer}};

Renderer renderer_called(const std::string& name) {
    std::string known;
    for (const Known& renderer : renderers) {
        if (renderer.name == name) return renderer.open();
        known += (known.empty() ? "'" : ", '") + std::string(renderer.name) + "'";
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
