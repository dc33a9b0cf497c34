/// What holds for scenes and views of all magnitudes: nothing ends the program, what is not judged is refused,
/// and what is judged is judged right.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>

#include "compare/explanation/explain.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "rasterizer/rasterizer.h"
#include "scenes/judged_ranges.h"
#include "tests/magnitudes/drawn_view.h"

namespace zproof {
namespace {

bool is_judged(const DrawnView& drawn) {
    return outside_judged_ranges(drawn.scene).empty() && outside_judged_ranges(drawn.view).empty();
}

std::uint64_t covered(const Frame& frame) {
    const auto& ids = frame.primitive.pixels();
    return ids.size() - std::uint64_t(std::ranges::count(ids, PrimitiveId::none));
}

/// How many draws were judged, and in how many of them something was seen for certain.
struct Tally {
    int judged = 0, seen = 0, undecidable = 0;
};

/// The camera, and the first finding in words.
std::string told(const DrawnView& drawn, const Verdict& verdict) {
    const Camera& c = drawn.view.camera;
    std::ostringstream text;
    text << (c.projection == Projection::parallel ? "parallel" : "perspective") << ", eye (" << c.eye_world.x
         << ", " << c.eye_world.y << ", " << c.eye_world.z << "), window " << c.window.left << " "
         << c.window.right << " " << c.window.bottom << " " << c.window.top << ", near " << c.near_depth
         << ", far " << c.far_depth << ", shear " << c.shear.x << " " << c.shear.y << "\n";
    if (!verdict.findings.empty()) text << in_words(drawn.scene, verdict.findings.front());
    return text.str();
}

void judge_drawn(const DrawnView& drawn, Tally& tally) {
    const Frame reference = oracle::Embree(drawn.scene).trace(drawn.view);
    const Frame candidate = rasterizer::render(drawn.scene, drawn.view);
    const Verdict verdict = judge(drawn.scene, drawn.view, {candidate, rasterizer::precision()},
                                  {reference, oracle::embree_precision()});
    EXPECT_EQ(defect_count(verdict), 0u) << told(drawn, verdict);
    EXPECT_EQ(verdict.reference_defects, 0u);
    const Verdict coarse =
        judge(drawn.scene, drawn.view, {candidate, RasterPrecision{}}, {reference, oracle::embree_precision()});
    EXPECT_EQ(defect_count(coarse), 0u) << told(drawn, coarse);
    EXPECT_EQ(verdict.counts[std::size_t(PixelClass::reference_wrong)], 0u);
    ++tally.judged;
    tally.undecidable += undecidable_count(verdict) > 0;
    tally.seen += covered(candidate) > 0 && verdict.counts[std::size_t(PixelClass::agree)] > 0;
}

Tally judge_all(std::uint32_t first, std::uint32_t end) {
    Tally tally;
    for (std::uint32_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE(seed);
        const DrawnView drawn = drawn_view(seed);
        const auto begun=std::chrono::steady_clock::now();struct T{std::chrono::steady_clock::time_point b;const DrawnView&d;std::uint32_t s;~T(){double e=std::chrono::duration<double>(std::chrono::steady_clock::now()-b).count(); if(e>0.2){Verdict v; std::cout<<s<<" took "<<e<<" "<<told(d,v);}}} tt{begun,drawn,seed};
        if (is_judged(drawn)) {
            judge_drawn(drawn, tally);
        } else {
            EXPECT_THROW(oracle::Embree(drawn.scene).trace(drawn.view), OracleError);
        }
    }
    return tally;
}

TEST(Magnitudes, HundredsOfDrawsAreRefusedOrJudgedRight) {
    const Tally tally = judge_all(0, 600);
    std::cout << tally.judged << " " << tally.seen << " " << tally.undecidable << "\n";
    EXPECT_GT(tally.judged, 200);
    EXPECT_GT(tally.seen, 150);
}

TEST(Magnitudes, ThousandsOfDrawsAreRefusedOrJudgedRight) {
    const Tally tally = judge_all(1000, 21'000);
    std::cout << tally.judged << " " << tally.seen << " " << tally.undecidable << "\n";
    EXPECT_GT(tally.seen, 5000);
}

}  // namespace
}  // namespace zproof
