/// The same bits for any number of threads and for every run.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>

#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/gate/suite_verdict.h"
#include "tests/support/same_verdict.h"

namespace zproof {
namespace {

bool same_bits(const Plane<float>& a, const Plane<float>& b) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return std::ranges::equal(a.pixels(), b.pixels(), {}, bits, bits);
}

bool same_bits(const Frame& a, const Frame& b) {
    return std::ranges::equal(a.primitive.pixels(), b.primitive.pixels()) &&
           same_bits(a.camera_depth, b.camera_depth);
}

struct Outcome {
    Frame candidate, reference;
    Verdict verdict, in_full;
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
        run.in_full = judge(loaded.scene, view, ours, theirs, full_detail);
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
        EXPECT_TRUE(same_bits(one.in_full.errors->candidate, other.in_full.errors->candidate));
        EXPECT_TRUE(same_bits(one.in_full.errors->reference, other.in_full.errors->reference));
        EXPECT_TRUE(std::ranges::equal(one.in_full.findings, other.in_full.findings, same_finding));
    }
}

TEST_P(Determinism, AVerdictIsTheSameInFull) {
    const Outcome run = run_on(2, generate_suite_scene(GetParam(), 640, 360));
    expect_same_counts(run.verdict, run.in_full);
    EXPECT_TRUE(std::ranges::equal(run.verdict.findings, defects_among(run.in_full.findings), same_finding));
}

INSTANTIATE_TEST_SUITE_P(Suite, Determinism,
                         testing::Values("coplanar", "deep_overdraw", "interpenetrating", "near_plane",
                                         "orthographic", "room", "shared_edges"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
