#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/renderers/registry.h"
#include "cli/threads.h"
#include "cli/work_progress.h"
#include "frame/precision_text.h"
#include "frame/whole_file.h"
#include "measure/measure.h"
#include "measure/promise.h"
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

}  // namespace

ExitCode execute(const MeasureArguments& arguments) {
    const measure::Renderer renderer = subject(arguments.renderer);
    note_interrupts();
    measure::Measurement measurement;
    Share instruments{0, measure::instrument_count};
    {
        WorkProgress progress{std::cerr, resolve(ProgressStyle::automatic), measure::about_all_pictures};
        const measure::ProgressSink progress_sink{
            .begins = [&](const std::string& what, int pictures) { progress.begin(what, pictures); },
            .ends = [&] { ++instruments.done; },
            .wants_to_stop = interrupted};
        on_threads(1,
                   [&] { measurement = measure::measure(renderer, progress_sink); });  // hundreds, all tiny
    }
    const auto findings = measure::findings(measurement, renderer.declared);
    std::cout << (arguments.format == MeasurementFormat::json ? measurement_json(renderer.name, findings)
                                                              : measurement_table(renderer.name, findings));
    if (instruments.done < instruments.all) return say_interrupted(instruments, "instrument", "read");
    if (!arguments.emit.empty()) emit(arguments.emit, measurement, renderer.declared);
    return measure::is_worse(findings) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
