/// zproof study on the command line.
#pragma once

#include "program/command.h"
#include "program/settings/sources.h"

namespace zproof {

/// What is not typed is taken from the settings. Throws UsageError, and ReportError where a settings file
/// that is named cannot be read.
Command parse_study(int argc, const char* const* argv, const Environment& environment);

}  // namespace zproof
