#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/renderers/registry.h"
#include "frame/precision_text.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "measure/measure.h"
#include "measure/promise.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/work_progress.h"
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
    measure::Measurement measurement;
    Share instruments{0, measure::instrument_count};
    {
        WorkProgress progress{std::cerr, progress_of(arguments.common), measure::about_all_pictures};
        const measure::ProgressSink progress_sink{
            .begins = [&](const std::string& what, int pictures) { progress.begin(what, pictures); },
            .ends = [&] { ++instruments.done; },
            .wants_to_stop = interrupted};
        constexpr int of_tiny_pictures = 1;  // there are hundreds of them
        on_threads(of_tiny_pictures, [&] { measurement = measure::measure(renderer, progress_sink); });
    }
    const auto findings = measure::findings(measurement, renderer.declared);
    std::cout << told(arguments, renderer.name, findings);
    if (instruments.done < instruments.all) return say_interrupted(instruments, "instrument", "read");
    if (!arguments.emit.empty()) emit(arguments.emit, measurement, renderer.declared);
    return measure::is_worse(findings) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
