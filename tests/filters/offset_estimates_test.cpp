/// What the joint check tells of offsets is true: on a grid of them the truth lies within three standard
/// errors, or no figure is told.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "filters/commands/joint_check.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

using selftest::FilterClaim;
using selftest::FilterFixture;

struct Truth {
    double lod, u, v;
};

JointConformance estimated(const Picture& picture) {
    static const FilterFixture ground = near_ground();
    static const JointCheck check =
        joint_check_of(ground, {.method = "trilinear-gl", .precision = gpu_with_exact_lod()});
    return check.judge(picture);
}

Picture with_offsets(const Truth& truth, LimitedTrilinear parts) {
    static const FilterFixture ground = near_ground();
    parts.place_error = {truth.u, truth.v};
    return rasterizer::filtered(ground.scene, ground.view, ground.frame,
                                {.method = limited_trilinear(parts), .options = {.lod_bias = truth.lod}});
}

bool covers(const OffsetEstimate& estimate, double truth) {
    return std::abs(estimate.value - truth) <= 3 * estimate.standard_error + 1e-7;
}

void expect_told(const Truth& truth, const LimitedTrilinear& parts) {
    const JointConformance found = estimated(with_offsets(truth, parts));
    std::cout << truth.lod << " " << truth.u << " " << truth.v << ":\n";
    for (const std::string& line : in_words(found)) std::cout << "    " << line << "\n";
    if (!found.are_offsets_known()) {
        EXPECT_GT(std::abs(truth.u), 1) << "not told, though it is small";
        return;
    }
    EXPECT_TRUE(covers(found.offsets[0], truth.lod)) << truth.lod;
    EXPECT_TRUE(covers(found.offsets[1], truth.u)) << truth.u;
    EXPECT_TRUE(covers(found.offsets[2], truth.v)) << truth.v;
    EXPECT_EQ(found.offsets[0].leaves_promise, std::abs(truth.lod) > 0.05);
    EXPECT_EQ(found.offsets[1].leaves_promise, std::abs(truth.u) > 0.05);
    EXPECT_EQ(found.offsets[2].leaves_promise, std::abs(truth.v) > 0.05);
}

TEST(OffsetEstimates, CoverTheTruthOfASamplerLikeACards) {
    for (const Truth& truth : {Truth{0.5, 0, 0},
                               {0, 0.5, 0},
                               {0, 0, -0.5},
                               {0.5, 0.5, -0.5},
                               {-0.5, 0.25, 0},
                               {1, 0, 0},
                               {0.1, -0.1, 0.1},
                               {0, 0.75, 0.75},
                               {0.01, 0, 0},
                               {0, 2.5, 0}})
        expect_told(truth, like_a_card());
}

TEST(OffsetEstimates, CoverTheTruthOfAnExactSampler) {
    for (const Truth& truth : {Truth{0.5, 0.5, -0.5}, {0, 0.75, 0.75}, {0, 2.5, 0}}) expect_told(truth, {});
}

TEST(OffsetEstimates, AreNotToldOfAPictureThatNoOffsetMakes) {
    static const FilterFixture ground = near_ground();
    const JointConformance found = estimated(
        rasterizer::filtered(ground.scene, ground.view, ground.frame,
                             {.method = limited_trilinear({.weights = {.bits = 3}, .blend = {.bits = 3}})}));
    EXPECT_FALSE(found.are_offsets_known());
    EXPECT_NE(in_words(found).front().find("not told: large, or no offset"), std::string::npos);
}

}  // namespace
}  // namespace zproof
