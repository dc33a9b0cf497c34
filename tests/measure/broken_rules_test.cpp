// Every broken rule that shows in a measurement is measured as what it is, and nothing else turns worse.
#include <gtest/gtest.h>

#include "subjects.h"

namespace zproof::measure {
namespace {

using Names = std::vector<std::string>;

struct Expected {
    const char* rule;
    rasterizer::Rules rules;
    Names worse;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.rule; }

const std::vector<Expected> broken{
    {"SampleInTheCorner", {.sample_offset_px = 0}, {"pixel_centre_x", "pixel_centre_y"}},
    {"FourSubpixelBits",
     {.subpixel_bits = 4},
     {"subpixel_bits_x", "vertex_shift_x", "subpixel_bits_y", "vertex_shift_y"}},
    {"Truncated", {.snap = Snap::truncate}, {"vertex_shift_x", "snap_x", "vertex_shift_y", "snap_y"}},
    {"NobodyOwnsAnEdge", {.fill = rasterizer::FillRule::exclusive}, {"fill_side", "holes"}},
    {"EverybodyOwnsAnEdge", {.fill = rasterizer::FillRule::inclusive}, {"fill_side", "double_hits"}},
    {"NoNearClip",
     {.near_clip = rasterizer::NearClip::just_before_the_eye},
     {"near_parallel", "near_perspective"}},
    {"DepthTestTurnedRound", {.depth_test = rasterizer::DepthTest::farther_wins}, {"unmeasured"}},
};

class BrokenRule : public testing::TestWithParam<Expected> {};

TEST_P(BrokenRule, IsFoundAndNothingElse) {
    EXPECT_EQ(worse_in(findings(measure(by_rules(GetParam().rules)), rasterizer::precision())),
              GetParam().worse);
}

INSTANTIATE_TEST_SUITE_P(Rules, BrokenRule, testing::ValuesIn(broken),
                         [](const auto& row) { return std::string{row.param.rule}; });

TEST(BrokenRule, AnImageUpsideDownCannotBeMeasuredAndIsWorse) {
    const auto all =
        findings(measure(by_rules({.raster_y = rasterizer::RasterY::up})), rasterizer::precision());
    EXPECT_TRUE(is_worse(all));
    EXPECT_NE(finding(all, "unmeasured").words.find("upside down"), std::string::npos);
}

}  // namespace
}  // namespace zproof::measure
