// Stand-in for TBB; see run_threads.h. Nobody cancels anything.
#pragma once

namespace tbb {

inline bool is_current_task_group_canceling() { return false; }

}  // namespace tbb
