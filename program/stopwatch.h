#pragma once

#include <chrono>
#include <utility>

namespace zproof {

/// Seconds of wall clock between one lap and the next.
class Stopwatch {
  public:
    double lap() {
        const auto now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

}  // namespace zproof
