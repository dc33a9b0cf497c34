/// Where the time of a scene goes, kept while it goes: also a stage that fails has taken its time.
#pragma once

#include "program/stopwatch.h"
#include "reports/results.h"

namespace zproof {

class StageClock {
  public:
    /// The stage in hand ends; this one begins. A stage may be begun more than once.
    void begin(double StageTimes::*stage) {
        times_.*stage_ += watch_.lap();
        stage_ = stage;
    }

    /// What was measured since the last take(); the stage in hand goes on.
    StageTimes take() {
        begin(stage_);
        return std::exchange(times_, {});
    }

  private:
    double StageTimes::*stage_ = &StageTimes::load;
    StageTimes times_;
    Stopwatch watch_;
};

}  // namespace zproof
