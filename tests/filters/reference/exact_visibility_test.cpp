#include <gtest/gtest.h>

#include <cmath>

#include "filters/reference/admissible_surfaces.h"
#include "tests/oracle/brute_force.h"

namespace zproof::oracle {
namespace {

class ExactVisibility : public testing::TestWithParam<ProjectionKind> {};

TEST_P(ExactVisibility, AgreesWithBruteForce) {
    const auto one_rounding = [](const View&, double depth) { return std::abs(depth) * 0x1.01p-24; };
    expect_agreement({.cast = exact_visibility, .scenes = 40, .depth_error = one_rounding}, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Filters, ExactVisibility,
                         testing::Values(ProjectionKind::perspective, ProjectionKind::off_axis,
                                         ProjectionKind::orthographic, ProjectionKind::oblique));

}  // namespace
}  // namespace zproof::oracle
