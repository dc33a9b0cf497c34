/// How many faults the gate catches, told fault by fault.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/selftest/fault.h"

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

/// Tries every fault on a fixture of its size and tells a line of each, until the progress sink wants to
/// stop. Uses the surrounding tbb::task_arena.
Score try_all(const std::vector<Fault>& faults, const ProgressSink& progress_sink);

}  // namespace zproof::selftest
