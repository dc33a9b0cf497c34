#pragma once

#include <string_view>
#include <vector>

#include "program/exit_code.h"
#include "reports/results.h"

namespace zproof {

/// The run's exit code. Where several apply, it is the one that proves least: internal, then interrupted,
/// then cannot_judge, then nothing, then defect. A waiver that fails the gate (reports/waiver_status.h) is a
/// defect.
ExitCode exit_code_of(const Results& results);

/// The worst of several runs, by the same order. ExitCode::nothing only where none of them judged anything.
ExitCode worst_of(const std::vector<ExitCode>& codes);

/// The verdict on a whole run: "proven", "defect", "cannot judge everything", ...
std::string_view in_words(ExitCode code);

}  // namespace zproof
