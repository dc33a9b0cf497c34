/// What is timed, a function per part of zproof. Each registers its benchmarks as TOPIC/CASE/WHO, where WHO
/// is "zproof" or a peer that does the same job on the same case: bench/figures.py makes ratios of them.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace zproof::bench {

void add_rasterizer();
void add_oracle();
void add_judge();
void add_load();
void add_tables();
void add_filters();
void add_truth();

/// `count` are counted per second, where there are any.
struct Items {
    std::string name;
    double count = 0;
};

/// Says that something is new the first time that it is asked.
inline std::function<bool()> new_once() {
    return [asked = std::make_shared<bool>(false)] { return !std::exchange(*asked, true); };
}

/// Wall clock of the iteration, and processor time of all threads beside it. `prepare` is called before every
/// repetition, which others may have come before; where it says that what the work needs is new, the first
/// call makes the rest of it. Neither is timed.
template <class Work>
void add(const std::string& name, const Work& work, const Items& items = {},
         const std::function<bool()>& prepare = new_once()) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) {
                                     if (prepare()) work();
                                     for (auto _ : state) work();
                                     if (items.count > 0)
                                         state.counters[items.name] = benchmark::Counter(
                                             items.count, benchmark::Counter::kIsIterationInvariantRate);
                                 })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

}  // namespace zproof::bench
