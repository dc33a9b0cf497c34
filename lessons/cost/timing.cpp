#include "lessons/cost/timing.h"

#include <tbb/task_arena.h>
#include <time.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace zproof::study::cost {
namespace {

double thread_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

Timing timing_of(std::vector<double> times) {
    std::ranges::sort(times);
    const std::size_t n = times.size();
    return {times[n / 2], times[n / 4], times[3 * n / 4], int(n)};
}

}  // namespace

Timing timed(int runs, const std::function<void()>& work) {
    return timed_in_turn(runs, std::span(&work, 1)).front();
}

std::vector<Timing> timed_in_turn(int runs, std::span<const std::function<void()>> works) {
    std::vector<std::vector<double>> times(works.size());
    tbb::task_arena alone(1);
    alone.execute([&] {
        for (const auto& work : works) work();
        for (int i = 0; i < runs; ++i)
            for (std::size_t w = 0; w < works.size(); ++w) {
                const double start = thread_nanoseconds();
                works[w]();
                times[w].push_back(thread_nanoseconds() - start);
            }
    });
    std::vector<Timing> timings;
    for (std::vector<double>& of_work : times) timings.push_back(timing_of(std::move(of_work)));
    return timings;
}

}  // namespace zproof::study::cost
