#include "cli/measurement_run.h"

#include <iostream>

#include "program/work_progress.h"

namespace zproof {

MeasurementRun measured(const measure::Renderer& renderer, const CommonArguments& common) {
    MeasurementRun run{.measurement = {}, .instruments = {0, measure::instrument_count}};
    WorkProgress progress{std::cerr, progress_of(common), measure::about_all_pictures};
    const measure::ProgressSink progress_sink{
        .begins = [&](const std::string& what, int pictures) { progress.begin(what, pictures); },
        .ends = [&] { ++run.instruments.done; },
        .wants_to_stop = interrupted};
    constexpr int of_tiny_pictures = 1;  // there are hundreds of them
    on_threads(of_tiny_pictures, [&] { run.measurement = measure::measure(renderer, progress_sink); });
    return run;
}

}  // namespace zproof
