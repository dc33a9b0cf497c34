// Every benchmark, in one process so that peers meet the same machine. Figures for people: nothing depends on
// them. Options are Google Benchmark's, and --threads=N.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suites.h"
#include "math/processor.h"
#include "oracle/embree.h"
#include "rasterizer/kernel.h"

namespace {

constexpr std::string_view threads_option = "--threads=";

/// Takes our own option out of the command line.
int threads_of(std::vector<char*>& arguments) {
    int threads = tbb::task_arena::automatic;
    std::erase_if(arguments, [&](const char* argument) {
        if (!std::string_view{argument}.starts_with(threads_option)) return false;
        threads = std::stoi(argument + threads_option.size());
        return true;
    });
    return threads;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace zproof;
    std::vector<char*> arguments(argv, argv + argc);
    tbb::task_arena arena(threads_of(arguments));
    int count = int(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    benchmark::AddCustomContext("threads", std::to_string(arena.max_concurrency()));
    benchmark::AddCustomContext("rasterizer_kernels", widest_of(rasterizer::kernels).name);
    benchmark::AddCustomContext("reference", oracle::embree_version());
    arena.execute([] {
        bench::add_rasterizer();
        bench::add_oracle();
        bench::add_judge();
        bench::add_load();
        bench::add_tables();
        bench::add_filters();
        bench::add_truth();
        benchmark::RunSpecifiedBenchmarks();
    });
}
