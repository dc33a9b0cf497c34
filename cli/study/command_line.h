/// zproof study on the command line.
#pragma once

#include "cli/study/arguments.h"

namespace zproof {

/// Adds a subcommand for every study. Both must outlive the parsing.
void add_study(CLI::App& app, StudyArguments& arguments);

/// The study that was typed. Throws UsageError where none was.
StudyArguments chosen_study(const CLI::App& app, StudyArguments& arguments);

}  // namespace zproof
