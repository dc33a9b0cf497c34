/// The same bits for any number of threads and for every run.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>

#include "compare/judge_in_full.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/gate/trial.h"
#include "tests/support/same_verdict.h"

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
    Verdict verdict, with_histograms, in_full;
};

Outcome run_on(int threads, const Loaded& loaded) {
    Outcome run;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        const View& view = loaded.views.front();
        const oracle::Embree embree(loaded.scene);
        run.candidate = rasterizer::render(loaded.scene, view);
        run.reference = embree.trace(view);
        const RenderedFrame ours{run.candidate, rasterizer::precision()},
            theirs{run.reference, oracle::embree_precision()};
        run.verdict = judge(loaded.scene, view, ours, theirs);
        run.with_histograms = judge_with_histograms(loaded.scene, view, ours, theirs);
        run.in_full = judge_in_full(loaded.scene, view, ours, theirs).verdict;
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
        expect_same_counts(one.verdict, other.verdict);
        expect_same_counts(one.in_full, other.in_full);
        expect_same_histograms(one.in_full, other.in_full);
        EXPECT_TRUE(std::ranges::equal(one.in_full.findings, other.in_full.findings, same_finding));
    }
}

TEST_P(Determinism, AVerdictIsTheSameInFull) {
    const Outcome run = run_on(2, generate_suite_scene(GetParam(), 640, 360));
    expect_same_counts(run.verdict, run.in_full);
    expect_same_counts(run.with_histograms, run.in_full);
    expect_same_histograms(run.with_histograms, run.in_full);
    std::vector<Finding> failing;
    std::ranges::copy_if(run.in_full.findings, std::back_inserter(failing),
                         [](const Finding& f) { return !passes(f.verdict); });
    EXPECT_TRUE(std::ranges::equal(run.verdict.findings, failing, same_finding));
    EXPECT_TRUE(std::ranges::equal(run.with_histograms.findings, failing, same_finding));
}

INSTANTIATE_TEST_SUITE_P(Suite, Determinism,
                         testing::Values("coplanar", "deep_overdraw", "interpenetrating", "near_plane",
                                         "orthographic", "room", "shared_edges"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
