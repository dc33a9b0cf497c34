#pragma once

#include <string_view>

#include "cli/exit_code.h"
#include "reports/results.h"

namespace zproof {

enum class Ending { complete, interrupted };

/// Where several codes apply, the one that proves least: interrupted, then cannot_judge, then nothing, then
/// defect.
ExitCode exit_code_of(const Results& results, Ending ending);

/// The verdict on a whole run: "proven", "defect", "cannot judge everything", ...
std::string_view in_words(ExitCode code);

}  // namespace zproof
