/// How many faults the gate catches, told fault by fault.
#pragma once

#include <vector>

#include "program/selftest_score.h"
#include "selftest/fault.h"

namespace zproof::selftest {

/// Tries every fault on a fixture of its size and tells a line of each, until the progress sink wants to
/// stop. Uses the surrounding tbb::task_arena.
Score try_all(const std::vector<Fault>& faults, const ProgressSink& progress_sink);

}  // namespace zproof::selftest
