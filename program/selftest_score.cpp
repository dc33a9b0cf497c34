#include "program/selftest_score.h"

#include <iostream>

#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/work_progress.h"

namespace zproof::selftest {

ExitCode score_told(const CommonArguments& common, int tests,
                    const std::function<Score(const ProgressSink&)>& try_all) {
    note_interrupts();
    Score score;
    {
        WorkProgress progress{std::cerr, progress_beside_lines(common), double(tests)};
        const ProgressSink progress_sink{.begins = [&](const std::string& name) { progress.begin(name); },
                                         .told =
                                             [&](const std::string& line) {
                                                 if (!common.is_quiet()) progress.say(std::cout, line);
                                             },
                                         .wants_to_stop = interrupted};
        on_threads(common.threads, [&] { score = try_all(progress_sink); });
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

}  // namespace zproof::selftest
