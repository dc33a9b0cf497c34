/// A check says what it could have seen, and proves nothing where that is nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "filters/commands/check_power.h"
#include "filters/commands/joint_check.h"
#include "filters/selftest/filter_fault.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

using selftest::FilterClaim;
using selftest::FilterFixture;

CheckPower power(const FilterFixture& fixture, const FilterClaim& claim) {
    const Picture right = selftest::picture_under({}, fixture, claim);
    const Conformance found = selftest::conformance_of(right, fixture, claim).found;
    const CheckPower power = power_of(fixture, claim, found, joint_check_of(fixture, claim));
    for (const std::string& line : in_words(power, found)) std::cout << "    " << line << "\n";
    return power;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// The same ground with corners a thousand times as far away: 24 bits place nothing.
FilterFixture far_corners() {
    FilterFixture fixture = near_ground();
    for (std::size_t i = 0; i < fixture.scene.vertices.position_world.size(); ++i) {
        fixture.scene.vertices.position_world[i] *= 1000;
        fixture.scene.vertices.uv[0][i] *= 1000;
    }
    fixture.frame = oracle::exact_visibility(fixture.scene, fixture.view);
    return fixture;
}

TEST(CheckPower, APromiseOfACardSeesHalfATexelAndHalfALevelOnNearGround) {
    const CheckPower near =
        power(near_ground(), {.method = "trilinear-gl", .precision = *preset_filter_precision("gpu")});
    EXPECT_TRUE(near.proves_something());
    for (const char* name : {"0.5 texels along u", "0.5 texels along v", "LOD + 0.5", "LOD - 0.5",
                             "steps by 2 x 2 differences", "mip-nearest-bilinear instead"})
        EXPECT_TRUE(has(near.refused, name)) << name;
}

TEST(CheckPower, NothingIsProvedWhereCornersAreFarAway) {
    const CheckPower far =
        power(far_corners(), {.method = "trilinear-gl", .precision = *preset_filter_precision("gpu")});
    EXPECT_FALSE(far.proves_something());
    EXPECT_TRUE(has(far.settings, "arithmetic_bits=53"));
    EXPECT_GT(far.wide_share, 0.5);
}

/// A check that could not tell another method from the claimed one proves nothing of the claim.
TEST(CheckPower, NothingIsProvedWhereASimplerMethodWouldPass) {
    const CheckPower near =
        power(near_ground(), {.method = "bicubic", .precision = *preset_filter_precision("gpu")});
    EXPECT_TRUE(near.proves_something());
    EXPECT_TRUE(has(near.refused, "bilinear instead"));
    const CheckPower far =
        power(far_corners(), {.method = "bicubic", .precision = *preset_filter_precision("gpu")});
    EXPECT_TRUE(has(far.unproven, "bilinear instead"));
}

/// With a slack of a level the promise itself admits one level alone: that is no blindness of the check.
TEST(CheckPower, WhatThePromiseAdmitsIsListedAlone) {
    const CheckPower found =
        power(near_ground(), {.method = "trilinear-gl", .precision = *preset_filter_precision("vulkan-min")});
    EXPECT_TRUE(has(found.admitted, "mip-nearest-bilinear instead"));
    EXPECT_FALSE(has(found.unproven, "mip-nearest-bilinear instead"));
}

TEST(CheckPower, ASlackThatIsPromisedIsNoBlindness) {
    FilterPrecision slack = *preset_filter_precision("gpu");
    slack.lod_below = 0.5, slack.lod_above = 1;
    const CheckPower found = power(near_ground(), {.method = "trilinear-gl", .precision = slack});
    EXPECT_TRUE(has(found.refused, "LOD + 1.5"));
}

/// Of one colour every filter makes that colour.
TEST(CheckPower, APictureOfOneColourProvesNothing) {
    FilterFixture plain = near_ground();
    for (std::uint8_t& texel : plain.scene.images[0].texels) texel = 128;
    const CheckPower found =
        power(plain, {.method = "trilinear-gl", .precision = *preset_filter_precision("float32")});
    EXPECT_FALSE(found.proves_something());
    EXPECT_TRUE(found.refused.empty());
    EXPECT_TRUE(found.unproven.empty());
}

}  // namespace
}  // namespace zproof
