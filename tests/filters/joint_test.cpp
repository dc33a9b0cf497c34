/// The joint check: errors that hide within every pixel's range are seen over the picture, and pictures that
/// keep their promise pass.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "filters/commands/joint_check.h"
#include "filters/commands/precision_words.h"
#include "filters/methods/catalogue.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

using selftest::FilterClaim;
using selftest::FilterFixture;
using selftest::Ground;

const FilterPrecision hardware = gpu_with_exact_lod();

const FilterFixture& noise() {
    static const FilterFixture fixture = near_ground();
    return fixture;
}

Picture drawn(const FilterFixture& fixture, const texture::Method& method) {
    return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                {.method = method, .options = {}});
}

JointConformance joint(const texture::Method& method, const std::string& name,
                       const FilterFixture& fixture = noise()) {
    const FilterClaim claim{.method = name, .precision = hardware};
    const Picture picture = drawn(fixture, method);
    std::cout << "    " << selftest::in_words(selftest::conformance_of(picture, fixture, claim)) << "\n";
    const JointConformance found = joint_conformance_of(picture, fixture, claim);
    for (const std::string& line : in_words(found)) std::cout << "    " << line << "\n";
    return found;
}

const Lattice eight{8, Rounding::nearest}, eight_down{8, Rounding::down};

TEST(Joint, RoundedToNearestKeepsThePromise) {
    const auto found =
        joint(limited_trilinear({.lod = eight, .weights = eight, .blend = eight}), "trilinear-gl");
    EXPECT_FALSE(found.leaves_promise());
}

struct ApproximateLength {
    const char* method;
    double bias;
    bool is_vulkans;  ///< a step's length is taken as 1 / sqrt(2) to 2 of it
};

/// Is it caught as trilinear-gl that promises this?
bool is_caught(const ApproximateLength& drawn_as, const FilterPrecision& promise) {
    const FilterFixture tilted = selftest::filter_fixture(Ground::noise);
    const Picture picture = rasterizer::filtered(
        tilted.scene, tilted.view, tilted.frame,
        {.method = *texture::find_method(drawn_as.method), .options = {.lod_bias = drawn_as.bias}});
    return selftest::conformance_of(picture, tilted, {.method = "trilinear-gl", .precision = promise})
        .is_caught();
}

TEST(Joint, ApproximateLengthsKeepVulkansPromiseAndNoExactOne) {
    for (const ApproximateLength& length : {ApproximateLength{"trilinear-ellipse", 0, true},
                                            {"trilinear-gl", 0.99, true},
                                            {"trilinear-gl", -0.49, true},
                                            {"trilinear-gl", 1.1, false},
                                            {"trilinear-gl", -0.6, false}}) {
        EXPECT_EQ(is_caught(length, filter_precision_from_words({"gpu", "lod_slack=1"})), !length.is_vulkans)
            << length.method << " " << length.bias;
        EXPECT_TRUE(is_caught(length, *preset_filter_precision("gpu")))
            << length.method << " " << length.bias;
    }
}

TEST(Joint, RoundedDownKeepsThePromise) {
    const auto found = joint(
        limited_trilinear({.lod = eight_down, .weights = eight_down, .blend = eight_down}), "trilinear-gl");
    EXPECT_FALSE(found.leaves_promise());
    EXPECT_NEAR(found.offsets[0].value, -0x1p-9, 0x1p-11) << "both halves of a step";
}

/// Anything that errs by at most 2^-8, as drawn: more bits or an offset that leaves room for the rounding.
Lattice within_promise(std::mt19937& random) {
    const auto share = [&] { return double(random()) / 0x1p32; };
    const double bits = 8 + double(random() % 4), step = std::exp2(-bits), most = 0x1p-8;
    switch (random() % 4) {
        case 0:
            return {bits, Rounding::down, most - share() * (2 * most - step)};
        case 1:
            return {bits, Rounding::nearest, (2 * share() - 1) * (most - step / 2)};
        case 2:
            return {.offset = (random() % 2 == 0 ? most : -most)};
        default:
            return {.offset = (2 * share() - 1) * most};
    }
}

TEST(Joint, WhateverKeepsThePromisePasses) {
    std::mt19937 random{2026};
    for (int round = 0; round < 8; ++round) {
        LimitedTrilinear parts;
        parts.lod = within_promise(random);
        parts.weights = within_promise(random);
        parts.blend = within_promise(random);
        SCOPED_TRACE(round);
        EXPECT_FALSE(joint(limited_trilinear(parts), "trilinear-gl").leaves_promise())
            << parts.lod.bits << " " << parts.lod.offset << ", " << parts.weights.bits << " "
            << parts.weights.offset << ", " << parts.blend.bits << " " << parts.blend.offset;
    }
}

/// Head-on at three pixels a texel every third pixel has the same fractions: rows and columns repeat their
/// roundings.
TEST(Joint, RoundingsThatRepeatKeepThePromise) {
    for (const double texels_per_pixel : {1.0 / 3, 1.0}) {
        const FilterFixture wall = head_on_wall(texels_per_pixel);
        for (const Lattice& lattice : {eight, eight_down})
            EXPECT_FALSE(joint(limited_trilinear({.lod = lattice, .weights = lattice, .blend = lattice}),
                               "trilinear-gl", wall)
                             .leaves_promise())
                << texels_per_pixel;
    }
}

TEST(Joint, LodBiasIsSeen) {
    const auto found = joint(limited_trilinear({.lod = {.offset = 0.01}}), "trilinear-gl");
    EXPECT_TRUE(found.offsets[0].leaves_promise);
    EXPECT_NEAR(found.offsets[0].value, 0.01, 0.001);
}

TEST(Joint, LodBiasIsSeenBesideRounding) {
    const auto found =
        joint(limited_trilinear({.lod = {8, Rounding::nearest, 0.02}, .weights = eight, .blend = eight}),
              "trilinear-gl");
    EXPECT_TRUE(found.offsets[0].leaves_promise);
    EXPECT_NEAR(found.offsets[0].value, 0.02, 0.001);
}

TEST(Joint, PlaceIsSeen) {
    const auto found =
        joint(limited_trilinear({.lod = eight, .weights = eight, .blend = eight, .place_error = {0.01, 0}}),
              "trilinear-gl");
    EXPECT_TRUE(found.offsets[1].leaves_promise);
    EXPECT_FALSE(found.offsets[2].leaves_promise);
    EXPECT_NEAR(found.offsets[1].value, 0.01, 0.001);
}

TEST(Joint, GainIsEstimated) {
    const auto found = joint(
        limited_trilinear({.lod = eight, .weights = eight, .blend = eight, .gain = 1.0005}), "trilinear-gl");
    EXPECT_NEAR(found.offsets[3].value, 0.0005, 5 * found.offsets[3].standard_error);
    EXPECT_FALSE(found.offsets[3].leaves_promise) << "weights of 8 bits may flatten the contrast as much";
}

TEST(Joint, GainIsSeen) {
    const auto found = joint(
        limited_trilinear({.lod = eight, .weights = eight, .blend = eight, .gain = 1.02}), "trilinear-gl");
    EXPECT_TRUE(found.offsets[3].leaves_promise);
}

bool is_nearer(const JointConformance& found, const std::string& name) {
    const auto other = std::ranges::find(found.alternatives, name, &AlternativeFit::name);
    return other != found.alternatives.end() && other->is_nearer;
}

TEST(Joint, WeightsOfFewerBitsAreSeen) {
    EXPECT_TRUE(
        is_nearer(joint(limited_trilinear({.weights = {.bits = 6}, .blend = {.bits = 6}}), "trilinear-gl"),
                  "weights of 6 bits, rounded to the nearest"));
    EXPECT_TRUE(
        is_nearer(joint(limited_trilinear({.weights = {7, Rounding::down}, .blend = {7, Rounding::down}}),
                        "trilinear-gl"),
                  "weights of 7 bits, rounded down"));
}

TEST(Joint, LevelsOfFloat16AreSeen) {
    const auto with_halves = [](int from) {
        return joint(
            limited_trilinear({.lod = eight, .weights = eight, .blend = eight, .half_levels_from = from}),
            "trilinear-gl");
    };
    EXPECT_TRUE(is_nearer(with_halves(0), "levels of float16"));
    EXPECT_TRUE(is_nearer(with_halves(1), "levels above 0 of float16"));
}

TEST(Joint, LevelsOfFloat16ThatArePromisedPass) {
    const texture::Method halves = limited_trilinear({.half_levels_from = 1});
    FilterClaim claim;
    claim.method = "trilinear-gl";
    claim.precision = *preset_filter_precision("float32");
    const Picture picture = drawn(noise(), halves);
    EXPECT_TRUE(selftest::conformance_of(picture, noise(), claim).is_caught());
    claim.precision.texel_bits = 11;
    EXPECT_FALSE(selftest::conformance_of(picture, noise(), claim).is_caught());
    EXPECT_FALSE(joint_conformance_of(picture, noise(), claim).leaves_promise());
}

TEST(Joint, AnEllipseOfEightBitsKeepsThePromise) {
    for (const Lattice& weights : {eight, eight_down})
        EXPECT_FALSE(joint(limited_ellipse({.weights = weights}), "ewa-pbrt").leaves_promise());
}

}  // namespace
}  // namespace zproof
