#include "program/threads.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace zproof {

void on_threads(int count, const std::function<void()>& work) {
    const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, std::size_t(count)};
    tbb::task_arena arena{count};
    arena.execute(work);
}

}  // namespace zproof
