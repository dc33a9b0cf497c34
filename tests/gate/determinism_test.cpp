/// The same bits for any number of threads and for every run.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/gate/trial.h"

namespace zproof {
namespace {

bool same_bits(const Frame& a, const Frame& b) {
    const auto bits = [](float depth) { return std::bit_cast<std::uint32_t>(depth); };
    return std::ranges::equal(a.primitive.pixels(), b.primitive.pixels()) &&
           std::ranges::equal(a.camera_depth.pixels(), b.camera_depth.pixels(), {}, bits, bits);
}

bool same_finding(const Finding& a, const Finding& b) {
    return a.x == b.x && a.y == b.y && a.verdict == b.verdict && a.eps_px == b.eps_px &&
           a.candidate.primitive == b.candidate.primitive && a.reference.primitive == b.reference.primitive &&
           std::bit_cast<std::uint64_t>(a.error_over_bound) ==
               std::bit_cast<std::uint64_t>(b.error_over_bound);
}

struct Outcome {
    Frame candidate, reference;
    Verdict verdict;
};

Outcome run_on(int threads, const Loaded& loaded) {
    Outcome run;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        const View& view = loaded.views.front();
        const oracle::Embree embree(loaded.scene);
        run.candidate = rasterizer::render(loaded.scene, view);
        run.reference = embree.trace(view);
        run.verdict = judge(loaded.scene, view, {run.candidate, rasterizer::precision()},
                            {run.reference, oracle::embree_precision()});
    });
    return run;
}

class Determinism : public testing::TestWithParam<std::string> {};

TEST_P(Determinism, FramesAndVerdictsDoNotDependOnThreadsOrRuns) {
    const Loaded loaded = generate_suite_scene(GetParam(), 640, 360);
    const Outcome one = run_on(1, loaded);
    for (const int threads : {1, 2, 3}) {
        SCOPED_TRACE(threads);
        const Outcome other = run_on(threads, loaded);
        EXPECT_TRUE(same_bits(one.candidate, other.candidate));
        EXPECT_TRUE(same_bits(one.reference, other.reference));
        EXPECT_EQ(one.verdict.counts, other.verdict.counts);
        EXPECT_EQ(one.verdict.candidate_depth.histogram, other.verdict.candidate_depth.histogram);
        EXPECT_EQ(one.verdict.candidate_depth.max_error_over_bound,
                  other.verdict.candidate_depth.max_error_over_bound);
        EXPECT_EQ(one.verdict.candidate_edges.histogram, other.verdict.candidate_edges.histogram);
        EXPECT_TRUE(std::ranges::equal(one.verdict.findings, other.verdict.findings, same_finding));
    }
}

INSTANTIATE_TEST_SUITE_P(Suite, Determinism,
                         testing::Values("deep_overdraw", "interpenetrating", "near_plane", "room"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
