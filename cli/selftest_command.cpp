#include <iostream>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/selftest/filter_fault.h"
#include "cli/selftest/score.h"
#include "cli/threads.h"
#include "cli/work_progress.h"

namespace zproof {

ExitCode execute(const SelftestArguments& arguments) {
    const std::vector<selftest::Fault> faults = selftest::catalogue();
    const int tests = int(faults.size()) + selftest::filter_test_count();
    note_interrupts();
    selftest::Score score;
    {
        WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(tests)};
        const selftest::ProgressSink progress_sink{
            .begins = [&](const std::string& name) { progress.begin(name); },
            .told =
                [&](const std::string& line) {
                    if (!arguments.common.is_quiet()) progress.say(std::cout, line);
                },
            .wants_to_stop = interrupted};
        on_threads(arguments.common.threads, [&] {
            score = try_all(faults, progress_sink);
            score += selftest::try_filters(progress_sink);
        });
    }
    const std::string counts = std::to_string(score.caught) + " of " + std::to_string(score.faults) +
                               " faults caught, " + std::to_string(score.passed) + " of " +
                               std::to_string(score.controls) + " good frames passed\n";
    if (score.tests() < tests) {
        std::cout << "so far: " << counts << std::flush;
        return say_interrupted({std::size_t(score.tests()), std::size_t(tests)}, "test", "run");
    }
    std::cout << (score.gate_works() ? "the gate works: " : "THE GATE DOES NOT WORK: ") << counts;
    return score.gate_works() ? ExitCode::proven : ExitCode::defect;
}

}  // namespace zproof
