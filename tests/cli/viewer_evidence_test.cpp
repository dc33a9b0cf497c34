#include "cli/viewer_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zproof {
namespace {

Finding finding(int x, PixelClass kind, std::uint32_t candidate, std::uint32_t reference, double error) {
    return {.x = x,
            .y = 1,
            .verdict = kind,
            .candidate = {PrimitiveId(candidate), 1},
            .reference = {PrimitiveId(reference), 1},
            .candidate_depth = {},
            .error_over_bound = error};
}

std::vector<int> columns(const Verdict& verdict, std::size_t most) {
    std::vector<int> xs;
    for (const PixelCoord& place : telling_pixels(verdict, most)) xs.push_back(place.x);
    return xs;
}

TEST(TellingPixels, AreTheWorstOfEachPairSeverestClassFirst) {
    Verdict verdict;
    verdict.findings = {
        finding(0, PixelClass::edge, 1, 2, 0.1),           finding(1, PixelClass::edge, 2, 1, 0.9),
        finding(2, PixelClass::wrong_depth, 5, 5, 2),      finding(3, PixelClass::wrong_depth, 5, 5, 41),
        finding(4, PixelClass::hole, 0xFFFF'FFFF, 5, NAN), finding(5, PixelClass::edge, 3, 4, NAN)};
    EXPECT_EQ(columns(verdict, 1), (std::vector<int>{4}));
    EXPECT_EQ(columns(verdict, 2), (std::vector<int>{3, 4}));
    EXPECT_EQ(columns(verdict, 4), (std::vector<int>{1, 3, 4, 5})) << "each pair, before a second of any";
    EXPECT_EQ(columns(verdict, 5), (std::vector<int>{1, 2, 3, 4, 5})) << "then the worst that are left";
    EXPECT_EQ(columns(verdict, 99).size(), 6u);
    EXPECT_TRUE(columns({}, 9).empty());
}

}  // namespace
}  // namespace zproof
