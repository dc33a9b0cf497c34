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
    int trials() const { return faults + controls; }

    /// Everything is caught, nothing good is called bad, and there was something to catch.
    bool gate_works() const { return faults > 0 && caught == faults && passed == controls; }
};

/// Who follows the trials.
struct Audience {
    std::function<void(const std::string& name)> begins = [](const std::string&) {};
    std::function<void(const std::string& line)> told;           ///< what came of a trial; ends in a newline
    std::function<bool()> wants_to_stop = [] { return false; };  ///< asked before every trial
};

/// Tries every fault on a stage of its size and tells a line of each, until the audience wants to stop. Uses
/// the surrounding tbb::task_arena.
Score try_all(const std::vector<Fault>& faults, const Audience& audience);

}  // namespace zproof::selftest
