// conformance: one page of promises, with what a run writes (docs/conformance.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(Conformance, OfOurRasterizerKeepsEveryPromise) {
    const Folder folder;
    const Ran ran = run(folder, {"conformance", "zproof", "--random", "12", "-o", "c"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("zproof keeps all "));
    EXPECT_THAT(ran.out, HasSubstr("\nproven: 86 views; report: c/report.html"));
    const std::string page = folder.read("c/report.html");
    EXPECT_LT(page.find("<h1>zproof keeps all "), page.find("<h1>All 86 views are proven.</h1>"));
    EXPECT_THAT(page, HasSubstr("<title>zproof: zproof keeps all "));
    const auto json = nlohmann::json::parse(folder.read("c/conformance.json"));
    EXPECT_EQ(json.at("sections").size(), 3u);
    EXPECT_EQ(nlohmann::json::parse(folder.read("c/results.json")).at("views").size(), 86u);
}

TEST(Conformance, OfABoasterFails) {
    const Folder folder;
    const Ran ran = run(folder, {"conformance", "zproof", "--random", "1", "--precision",
                                 "raster,subpixel_bits=9", "--no-diagnosis", "-o", "c"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, ContainsRegex("visibility, the suite .* NOT KEPT"));
    EXPECT_THAT(ran.out, ContainsRegex("sub-pixel bits, x .* NOT KEPT"));
    EXPECT_THAT(ran.out, ContainsRegex("zproof breaks [0-9]+ of [0-9]+ promises"));
    EXPECT_THAT(ran.out, HasSubstr("\ndefect: "));
}

TEST(Conformance, OfADeviceAsksItsTextures) {
    const Folder folder;
    const Ran ran =
        run(folder, {"conformance", "vulkan", "--device", "llvmpipe", "--random", "1", "-o", "c"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, ContainsRegex("trilinear filter .* 65,536 pixels, 0 outside +kept"));
    EXPECT_THAT(ran.out, HasSubstr("keeps all 31 promises"));
}

TEST(Conformance, OfAProgramThatDrawsNothingJudgesNothing) {
    const Folder folder;
    const Ran ran = run(folder, {"conformance", "false {out}", "--random", "1", "-o", "c"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, Not(HasSubstr("keeps")));
}

}  // namespace
}  // namespace zproof::test
