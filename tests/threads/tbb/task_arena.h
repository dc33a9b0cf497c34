// Stand-in for TBB; see run_threads.h.
#pragma once

#include <tbb/run_threads.h>

namespace tbb {

class task_arena {
  public:
    static constexpr int automatic = -1;
    explicit task_arena(int threads = automatic)
        : threads_(threads == automatic ? stand_in::concurrency : threads) {}

    template <typename Work>
    auto execute(const Work& work) const {
        struct Restored {
            int before = stand_in::concurrency;
            ~Restored() { stand_in::concurrency = before; }
        } const restored;
        stand_in::concurrency = threads_;
        return work();
    }

  private:
    int threads_;
};

namespace this_task_arena {

inline int max_concurrency() { return stand_in::concurrency; }

}  // namespace this_task_arena

}  // namespace tbb
