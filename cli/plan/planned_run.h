/// A shard of a plan, judged.
#pragma once

#include "cli/arguments.h"
#include "program/exit_code.h"

namespace zproof {

/// Judges what the plan gives to this shard, one run after the other, and writes the reports of each. Throws
/// ReportError where the plan is not of this zproof, UsageError where it has no such shard, SceneError where
/// the scenes are no longer those that it was made of.
ExitCode run_planned(const RunArguments& arguments);

}  // namespace zproof
