/// Where the declared precision lets too many triangles be shown, nobody decides, and nothing passes.
#include <gtest/gtest.h>

#include "compare/admissible/admissibility.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// More small triangles than are looked at around one pixel, all within 16 px, behind a wall.
TestScene crowded() {
    std::vector<Triangle> triangles{wall(4)};
    for (std::size_t i = 0; i <= most_neighbours; ++i) {
        const double x = double(i % 256) / 16, y = double(i / 256) / 16;
        triangles.push_back({{{x, y, 8}, {x + 0.03125, y, 8}, {x, y + 0.03125, 8}}});
    }
    TestScene t(Projection::parallel, 16, 16, triangles);
    answer_everywhere(t.reference, 0, 4);
    answer_everywhere(t.candidate, 1, 8);
    return t;
}

TEST(Undecidable, APixelWithTooManyTrianglesWithinEpsIsNeitherRightNorWrong) {
    TestScene t = crowded();
    t.candidate_precision = BoundedPrecision{.eps_px = 32};
    const Verdict verdict = t.verdict();
    EXPECT_EQ(undecidable_count(verdict), 256u);
    EXPECT_EQ(defect_count(verdict), 0u);
    EXPECT_FALSE(passes(PixelClass::undecidable));
    EXPECT_FALSE(is_defect(PixelClass::undecidable));
    ASSERT_FALSE(verdict.findings.empty());
    EXPECT_GE(verdict.findings.front().eps_px, 32);
}

TEST(Undecidable, AFinerPromiseDecides) {
    TestScene t = crowded();
    t.candidate_precision = BoundedPrecision{.eps_px = 1e-3};
    const Verdict verdict = t.verdict();
    EXPECT_EQ(undecidable_count(verdict), 0u);
    EXPECT_EQ(defect_count(verdict), 256u);
}

/// Where near and the sides may cut a triangle, and what that leaves may be cut, is work as well.
TEST(Undecidable, CutsOfATriangleCountAsWork) {
    TestScene t(Projection::parallel, 8, 8, {{{{-8, -8, 2}, {16, -8, 8}, {16, 24, 8}}}});
    t.view.camera.near_depth = 4;
    const ViewBounds bounds(t.view, BoundedPrecision{.eps_px = 0.165, .watertight = false});
    Neighbourhood around = neighbourhood_of(t.scene, t.view, bounds, {6, 4, 1, {0}}, 0.165);
    const std::size_t work = decide(around, PrimitiveId::none).work;
    around.clip_windows.clear();
    EXPECT_GE(work, decide(around, PrimitiveId::none).work + 4 * 4);
}

}  // namespace
}  // namespace zproof
