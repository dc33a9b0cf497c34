/// How many planted faults are caught, told fault by fault.
#pragma once

#include <functional>
#include <string>

#include "program/common_arguments.h"
#include "program/exit_code.h"

namespace zproof::selftest {

struct Score {
    int faults = 0, caught = 0;    ///< caught: with the class and the count that the fault must have
    int controls = 0, passed = 0;  ///< good frames

    Score& operator+=(const Score& other) {
        faults += other.faults, caught += other.caught;
        controls += other.controls, passed += other.passed;
        return *this;
    }
    int tests() const { return faults + controls; }

    /// Everything is caught, nothing good is called bad, and there was something to catch.
    bool gate_works() const { return faults > 0 && caught == faults && passed == controls; }
};

/// Follows the tests.
struct ProgressSink {
    std::function<void(const std::string& name)> begins = [](const std::string&) {};
    std::function<void(const std::string& line)> told;           ///< what came of a test; ends in a newline
    std::function<bool()> wants_to_stop = [] { return false; };  ///< asked before every test
};

/// Does the tests and tells of each on stdout, then the score. Proven where the gate works; what was done
/// until then where it is interrupted.
ExitCode score_told(const CommonArguments& common, int tests,
                    const std::function<Score(const ProgressSink&)>& try_all);

}  // namespace zproof::selftest
