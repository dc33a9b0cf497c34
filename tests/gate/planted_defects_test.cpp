/// A gate that has never failed is not known to work: seven known defects, each caught with the right class.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "tests/gate/suite_verdict.h"
#include "tests/support/planted_rules.h"

namespace zproof {
namespace {

struct Case {
    std::string defect, scene;
    std::vector<PixelClass> expected;  ///< classes that must occur
};

/// Names the case in the test's parameter line.
void PrintTo(const Case& planted, std::ostream* out) { *out << planted.defect << " in " << planted.scene; }

rasterizer::Rules rules_of(const std::string& defect) {
    const auto& all = rasterizer::planted_rules;
    return std::ranges::find(all, defect, &rasterizer::PlantedRules::name)->rules;
}

class PlantedDefect : public testing::TestWithParam<Case> {};

TEST_P(PlantedDefect, FailsTheGateWithTheRightClass) {
    const Case& planted = GetParam();
    for (const SuiteVerdict& suite_verdict :
         try_suite_scene(planted.scene, 480, 270, rules_of(planted.defect))) {
        SCOPED_TRACE(suite_verdict.name);
        EXPECT_GT(defect_count(suite_verdict.verdict), 0u);
        for (const PixelClass expected : planted.expected)
            EXPECT_GT(suite_verdict.verdict.counts[std::size_t(expected)], 0u) << name_of(expected);
        EXPECT_EQ(suite_verdict.verdict.reference_defects, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Rasterizer, PlantedDefect,
    testing::Values(Case{"half_pixel_shift", "room", {PixelClass::outside, PixelClass::wrong_depth}},
                    Case{"affine_depth", "room", {PixelClass::wrong_depth}},
                    Case{"exclusive_fill", "fan_at_pixel_centre", {PixelClass::hole}},
                    Case{"y_flipped", "room", {PixelClass::outside}},
                    Case{"no_near_clip", "near_plane", {PixelClass::outside}},
                    Case{"depth_test_reversed", "room", {PixelClass::hidden}},
                    Case{"four_subpixel_bits", "room", {PixelClass::outside, PixelClass::wrong_depth}}),
    [](const auto& planted) { return planted.param.defect; });

}  // namespace
}  // namespace zproof
