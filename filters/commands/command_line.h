/// zproof filters on the command line.
#pragma once

#include "program/command.h"
#include "program/command_line/outline.h"
#include "program/settings/sources.h"

namespace zproof {

/// What is not typed is taken from the settings. Throws UsageError, and ReportError where a settings file
/// that is named cannot be read.
Command parse_filters(int argc, const char* const* argv, const Environment& environment);

namespace filters_program {

/// The worked examples of the commands.
Examples examples();

/// What names of options stand for, for completion.
ValueKinds value_kinds();

}  // namespace filters_program

}  // namespace zproof
