/// The correct rasterizer and Embree on the whole suite, small: nothing unexplained at any size.
#include <gtest/gtest.h>

#include "scenes/suite.h"
#include "tests/gate/suite_verdict.h"

namespace zproof {
namespace {

class EverySuiteScene : public testing::TestWithParam<std::string> {};

TEST_P(EverySuiteScene, HasNoUnexplainedPixelAndKeepsItsBounds) {
    for (const SuiteVerdict& suite_verdict : try_suite_scene(GetParam(), 500, 281)) {
        SCOPED_TRACE(suite_verdict.name);
        EXPECT_EQ(defect_count(suite_verdict.verdict), 0u)
            << name_of(commonest_defect(suite_verdict.verdict));
        EXPECT_EQ(suite_verdict.verdict.reference_defects, 0u);
        EXPECT_LE(suite_verdict.verdict.candidate_depth.max_error_over_bound, 1);
        EXPECT_LE(suite_verdict.verdict.reference_depth.max_error_over_bound, 1);
        EXPECT_LE(suite_verdict.verdict.candidate_edges.max_error_over_bound, 1);
        EXPECT_LE(suite_verdict.verdict.reference_edges.max_error_over_bound, 1);
    }
}

std::vector<std::string> suite_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Suite, EverySuiteScene, testing::ValuesIn(suite_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
