#include "cli/commands.h"
#include "selftest/score.h"

namespace zproof {

ExitCode execute(const SelftestArguments& arguments) {
    const std::vector<selftest::Fault> faults = selftest::catalogue();
    return selftest::score_told(
        arguments.common, int(faults.size()),
        [&](const selftest::ProgressSink& progress_sink) { return try_all(faults, progress_sink); });
}

}  // namespace zproof
