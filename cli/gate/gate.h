/// What lets a run pass that has defects: the waivers, the day they are held against, and how strictly.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "compare/waivers/waiver.h"
#include "reports/results.h"

namespace zproof {

/// The gate's options on the command line.
struct GateArguments {
    std::filesystem::path waivers;  ///< file; empty: there are none
    std::optional<Day> today;       ///< nothing: by the clock, UTC
    Strictness strictness = Strictness::lenient;
};

struct Gate {
    std::vector<Waiver> waivers;
    Day today{};
    Strictness strictness = Strictness::lenient;
};

/// Reads the waivers. Throws UsageError where they are malformed, ReportError where there is no such file.
Gate open_gate(const GateArguments& arguments);

/// The day of the clock, UTC.
Day this_day();

}  // namespace zproof
