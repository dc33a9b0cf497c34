// How time and memory grow: one scene from nothing to the verdict, stage by stage, as a line of JSON. Every
// stage is told in seconds of wall clock (NAME_s) and of processor time on all threads (NAME_cpu_s), which a
// busy machine disturbs little.
//
//     zproof_growth COLUMNS ROWS WIDTH HEIGHT     a rippled sheet of 2 x COLUMNS x ROWS triangles
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "bench/scenes.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"

namespace {

using namespace zproof;

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

class StageTimer {
  public:
    template <class Work>
    auto run(const char* name, const Work& work) {
        const auto start = std::chrono::steady_clock::now();
        const double cpu_start = processor_seconds();
        auto result = work();
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        std::cout << "\"" << name << "_s\": " << spent.count() << ", \"" << name
                  << "_cpu_s\": " << processor_seconds() - cpu_start << ", ";
        return result;
    }
};

double peak_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) return 2;
    const int columns = std::atoi(argv[1]), rows = std::atoi(argv[2]);
    bench::TimedScene timed = bench::ripples(columns, rows);
    View& view = timed.view;
    view.width = std::atoi(argv[3]), view.height = std::atoi(argv[4]);
    const double scene_mib = double(timed.scene.triangles.size() * sizeof(timed.scene.triangles[0]) +
                                    timed.scene.vertices.position_world.size() * sizeof(glm::vec3)) /
                             (1 << 20);
    std::cout << "{\"triangles\": " << timed.scene.triangles.size() << ", \"width\": " << view.width
              << ", \"height\": " << view.height << ", \"scene_mib\": " << scene_mib
              << ", \"frame_mib\": " << 8.0 * view.width * view.height / (1 << 20) << ", ";
    StageTimer timer;
    std::optional embree = timer.run("build", [&] { return oracle::Embree{timed.scene}; });
    const Frame reference = timer.run("trace", [&] { return embree->trace(view); });
    std::cout << "\"mib_after_trace\": " << peak_mib() << ", ";
    embree.reset();
    const Frame candidate = timer.run("render", [&] { return rasterizer::render(timed.scene, view); });
    std::cout << "\"mib_after_render\": " << peak_mib() << ", ";
    const Verdict verdict = timer.run("judge", [&] {
        return judge(timed.scene, view, {candidate, rasterizer::precision()},
                     {reference, oracle::embree_precision()});
    });
    std::cout << "\"defects\": " << defect_count(verdict) << ", \"mib\": " << peak_mib() << "}\n";
}
