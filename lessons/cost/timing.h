/// Processor time of one thread.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace zproof::study::cost {

/// Nanoseconds of one run, over several.
struct Timing {
    double median = 0, low = 0, high = 0;  ///< low, high: the quartiles
    int runs = 0;
};

/// Runs the work once unmeasured, then `runs` times, each alone on the calling thread (tbb work included).
/// What is measured is that thread's processor time, so that others who use the machine cost nothing but what
/// they do to its caches and clock.
Timing timed(int runs, const std::function<void()>& work);

/// Times several works, in turn: what disturbs the machine for a while disturbs all of them alike.
std::vector<Timing> timed_in_turn(int runs, std::span<const std::function<void()>> works);

}  // namespace zproof::study::cost
