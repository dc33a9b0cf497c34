#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/measurement_run.h"
#include "frame/precision_text.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "measure/promise.h"
#include "program/interrupt.h"
#include "renderers/registry.h"
#include "reports/measurement_report.h"

namespace zproof {
namespace {

/// Writes the precision that was measured. Throws std::runtime_error, and leaves no file, where there is
/// none.
void emit(const std::filesystem::path& file, const measure::Measurement& measurement,
          const Precision& declared) {
    try {
        write_whole_file(file, precision_to_json(measure::measured_promise(measurement, declared)) + "\n");
    } catch (const measure::NoPromise& e) {
        throw std::runtime_error{file.string() + ": not written: " + e.what()};
    }
}

std::string told(const MeasureArguments& arguments, const std::string& renderer,
                 const std::vector<measure::Finding>& findings) {
    if (arguments.format == MeasurementFormat::json) return measurement_json(renderer, findings);
    const std::string table = measurement_table(renderer, findings);
    return arguments.common.is_quiet() ? last_line(table) : table;
}

}  // namespace

ExitCode execute(const MeasureArguments& arguments) {
    const measure::Renderer renderer = measured_renderer(arguments.renderer);
    note_interrupts();
    const auto [measurement, instruments] = measured(renderer, arguments.common);
    const auto findings = measure::findings(measurement, renderer.declared);
    std::cout << told(arguments, renderer.name, findings);
    if (instruments.done < instruments.all) return say_interrupted(instruments, "instrument", "read");
    if (!arguments.emit.empty()) emit(arguments.emit, measurement, renderer.declared);
    return measure::is_worse(findings) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
