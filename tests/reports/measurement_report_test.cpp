#include "reports/measurement_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace zproof {
namespace {

using measure::Bracket;
using measure::Conformity;
using measure::Finding;

const std::vector<Finding> sample_findings{
    {"subpixel_bits_x", "sub-pixel bits, x", Bracket{7.75, 8.25}, "bits", "", "8", Conformity::as_declared},
    {"snap_x", "snap, x", {}, "", "truncated", "nearest", Conformity::worse},
    {"holes", "holes", Bracket{0, 0}, "", "", "", Conformity::undeclared},
};

TEST(MeasurementTable, ShowsEachFindingAndTheVerdict) {
    EXPECT_EQ(measurement_table("mine", sample_findings),
              R"(finding            measured          declared  conformity
sub-pixel bits, x  8.0 +- 0.25 bits  8         as declared
snap, x            truncated         nearest   WORSE
holes              0                           -

mine: worse than declared in 1 of 3
)");
}

TEST(MeasurementTable, OfAFaithfulRendererSaysSo) {
    const std::string text = measurement_table("mine", std::span(sample_findings).first(1));
    EXPECT_TRUE(text.ends_with("\nmine: as declared\n")) << text;
}

TEST(MeasurementJson, KeepsBracketsAndConformity) {
    const auto json = nlohmann::json::parse(measurement_json("mine", sample_findings));
    EXPECT_EQ(json["renderer"], "mine");
    EXPECT_EQ(json["worse"], true);
    ASSERT_EQ(json["findings"].size(), 3u);
    EXPECT_EQ(json["findings"][0]["value"]["low"], 7.75);
    EXPECT_EQ(json["findings"][0]["value"]["high"], 8.25);
    EXPECT_EQ(json["findings"][1]["conformity"], "worse");
    EXPECT_FALSE(json["findings"][1].contains("value"));
}

}  // namespace
}  // namespace zproof
