#include <iostream>

#include "cli/commands.h"
#include "cli/selftest/filter_fault.h"
#include "cli/selftest/score.h"
#include "cli/threads.h"

namespace zproof {

ExitCode execute(const SelftestArguments& arguments) {
    selftest::Score score;
    on_threads(arguments.threads, [&] {
        score = try_all(selftest::catalogue(), std::cout);
        score += selftest::try_filters(std::cout);
    });
    std::cout << (score.gate_works() ? "the gate works: " : "THE GATE DOES NOT WORK: ") << score.caught
              << " of " << score.faults << " faults caught, " << score.passed << " of " << score.controls
              << " good frames passed\n";
    return score.gate_works() ? ExitCode::proven : ExitCode::defect;
}

}  // namespace zproof
