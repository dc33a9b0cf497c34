/// How many faults the gate catches, told fault by fault.
#pragma once

#include <iosfwd>
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
    /// Everything is caught, nothing good is called bad, and there was something to catch.
    bool gate_works() const { return faults > 0 && caught == faults && passed == controls; }
};

/// Tries every fault on a stage of its size; a line for each goes to `out`. Uses the surrounding
/// tbb::task_arena.
Score try_all(const std::vector<Fault>& faults, std::ostream& out);

}  // namespace zproof::selftest
