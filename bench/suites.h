/// What is timed, a function per part of zproof. Each registers its benchmarks as TOPIC/CASE/WHO, where WHO
/// is "zproof" or a peer that does the same job on the same case: bench/figures.py makes ratios of them.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace zproof::bench {

void add_rasterizer();
void add_oracle();
void add_judge();
void add_load();
void add_tables();
void add_filters();
void add_truth();

/// Wall clock of the iteration, and processor time of all threads beside it. The first call makes what the
/// work needs, and is not timed. `items`, where there are any, are counted per second.
struct Items {
    std::string name;
    double count = 0;
};
template <class Work>
void add(const std::string& name, const Work& work, const Items& items = {}) {
    const auto is_warm = std::make_shared<bool>(false);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) {
                                     if (!*is_warm) work();
                                     *is_warm = true;
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
