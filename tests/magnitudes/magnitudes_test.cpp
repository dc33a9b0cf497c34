/// What holds for scenes and views of all magnitudes: nothing ends the program, what is not judged is
/// refused, and what is judged is judged right.
#include <gtest/gtest.h>

#include <algorithm>
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

/// How many draws were judged, and in how many of them both saw the same triangle somewhere.
struct Tally {
    int judged = 0, seen = 0;
};

/// The camera, and what is wrong in words.
std::string told(const DrawnView& drawn, const Verdict& verdict) {
    const Camera& c = drawn.view.camera;
    std::ostringstream text;
    text << (c.projection == Projection::parallel ? "parallel" : "perspective") << ", eye (" << c.eye_world.x
         << ", " << c.eye_world.y << ", " << c.eye_world.z << "), window " << c.window.left << " "
         << c.window.right << " " << c.window.bottom << " " << c.window.top << ", near " << c.near_depth
         << ", far " << c.far_depth << ", shear " << c.shear.x << " " << c.shear.y << "\n";
    for (const Finding& finding : verdict.findings)
        if (is_defect(finding.verdict) || finding.verdict == PixelClass::reference_wrong)
            text << "(" << finding.x << ", " << finding.y << "): " << in_words(drawn.scene, finding) << "\n";
    return text.str();
}

void judge_drawn(const DrawnView& drawn, Tally& tally) {
    const Frame reference = oracle::Embree(drawn.scene).trace(drawn.view);
    const Frame candidate = rasterizer::render(drawn.scene, drawn.view);
    const Verdict verdict = judge(drawn.scene, drawn.view, {candidate, rasterizer::precision()},
                                  {reference, oracle::embree_precision()}, full_detail);
    EXPECT_EQ(defect_count(verdict), 0u) << told(drawn, verdict);
    EXPECT_EQ(verdict.reference_defects, 0u) << told(drawn, verdict);
    const Verdict coarse = judge(drawn.scene, drawn.view, {candidate, RasterPrecision{}},
                                 {reference, oracle::embree_precision()});
    EXPECT_EQ(defect_count(coarse), 0u) << told(drawn, coarse);
    ++tally.judged;
    tally.seen += covered(candidate) > 0 && verdict.counts[std::size_t(PixelClass::agree)] > 0;
}

Tally judge_all(std::uint32_t first, std::uint32_t end) {
    Tally tally;
    for (std::uint32_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE(seed);
        const DrawnView drawn = drawn_view(seed);
        if (is_judged(drawn)) {
            judge_drawn(drawn, tally);
        } else {
            EXPECT_THROW(oracle::Embree(drawn.scene).trace(drawn.view), OracleError);
        }
    }
    return tally;
}

TEST(Magnitudes, HundredsOfDrawsAreRefusedOrJudgedRight) {
    const Tally tally = judge_all(0, 300);
    EXPECT_GT(tally.judged, 100);
    EXPECT_GT(tally.seen, 80);
}

TEST(Magnitudes, ThousandsOfDrawsAreRefusedOrJudgedRight) {
    const Tally tally = judge_all(1000, 9000);
    EXPECT_GT(tally.judged, 2500);
    EXPECT_GT(tally.seen, 2000);
}

}  // namespace
}  // namespace zproof
