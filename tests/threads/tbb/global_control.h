// Stand-in for TBB; see run_threads.h. A loop has the threads of its task_arena, however many are allowed.
#pragma once

#include <cstddef>

namespace tbb {

class global_control {
  public:
    enum parameter { max_allowed_parallelism };
    global_control(parameter, std::size_t) {}
};

}  // namespace tbb
