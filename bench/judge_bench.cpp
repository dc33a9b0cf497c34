// What judging costs beside tracing the reference, at 1920 x 1080: processor time of all threads, the best of
// up to nine runs. A figure for people: nothing depends on it.
//
//     judge_bench [THREADS [SCENE]...]     one thread and the whole suite where nothing is said
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace {

using namespace zproof;

/// Best of nine; fewer where they would take more than two seconds.
template <class Work>
double best_seconds(const Work& work) {
    double best = 1e300, spent = 0;
    for (int run = 0; run < 9 && spent < 2; ++run) {
        const std::clock_t start = std::clock();
        work();
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        best = std::min(best, seconds);
        spent += seconds;
    }
    return best;
}

void time_scene(const std::string& name) {
    const Loaded loaded = generate_suite_scene(name, 1920, 1080);
    const oracle::Embree embree(loaded.scene);
    for (const View& view : loaded.views) {
        const Frame candidate = rasterizer::render(loaded.scene, view);
        Frame reference;
        Verdict verdict;
        const double trace = best_seconds([&] { reference = embree.trace(view); });
        const double judging = best_seconds([&] {
            verdict = judge(loaded.scene, view, {candidate, rasterizer::precision()},
                            {reference, oracle::embree_precision()});
        });
        std::printf(
            "%-34s trace %8.1f ms, judge %8.1f ms, ratio %7.2f; %7llu pixels adjudicated, %llu exactly\n",
            (name + "/" + view.name).c_str(), 1e3 * trace, 1e3 * judging, judging / trace,
            static_cast<unsigned long long>(verdict.adjudicated),
            static_cast<unsigned long long>(verdict.exact));
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    tbb::task_arena arena(argc > 1 ? std::atoi(argv[1]) : 1);
    std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
    if (names.empty())
        for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    arena.execute([&] {
        for (const std::string& name : names) time_scene(name);
    });
}
