/// What a run says at its end, and to whom.
#pragma once

#include <string>

#include "cli/arguments.h"
#include "program/exit_code.h"
#include "reports/results.h"
#include "reports/terminal.h"

namespace zproof {

/// Prints the verdict on stdout as the report arguments ask for it, and remarks about waivers on stderr;
/// tells GitHub where its format is asked for: annotations on stdout, the summary into the file that
/// $GITHUB_STEP_SUMMARY names. Returns the verdict: the worse one of the results' and the one beside them.
/// Throws ReportError where that file cannot be written.
ExitCode announce(const Results& results, const ReportArguments& report, SummaryStyle::Rows rows,
                  ExitCode beside = ExitCode::nothing);

/// Seconds of wall clock per stage, over all views, each with its share. Ends in a newline.
std::string times_table(const Results& results);

}  // namespace zproof
