#include "study/cost/timing.h"

#include <tbb/task_arena.h>
#include <time.h>

#include <algorithm>
#include <vector>

namespace zproof::study::cost {
namespace {

double thread_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

}  // namespace

Timing timed(int runs, const std::function<void()>& work) {
    std::vector<double> times;
    tbb::task_arena alone(1);
    alone.execute([&] {
        work();
        for (int i = 0; i < runs; ++i) {
            const double start = thread_nanoseconds();
            work();
            times.push_back(thread_nanoseconds() - start);
        }
    });
    std::ranges::sort(times);
    const std::size_t n = times.size();
    return {times[n / 2], times[n / 4], times[3 * n / 4], runs};
}

}  // namespace zproof::study::cost
