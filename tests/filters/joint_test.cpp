/// The joint check: errors that hide within every pixel's range are seen over the picture, and pictures that
/// keep their promise pass.
#include <gtest/gtest.h>

#include <iostream>
#include <numbers>
#include <random>

#include "cli/filters/joint_check.h"
#include "rasterizer/rasterizer.h"
#include "tests/filters/limited_sampler.h"

namespace zproof {
namespace {

using selftest::FilterClaim;
using selftest::FilterFixture;
using selftest::Ground;

/// What graphics hardware promises: 8 bits of weights and of the LOD, coordinates of 22 bits, float32.
constexpr FilterPrecision hardware{.arithmetic_bits = 24,
                                   .coordinate_bits = 22,
                                   .weight_bits = 8,
                                   .lod_bits = 8,
                                   .sum_bits = 24,
                                   .sum_roundings = 80,
                                   .colour_bits = 22};

/// The ground of noise, small enough that its coordinates' float32 does not hide a hundredth of a texel:
/// magnified in the lower half, minified in the upper one.
FilterFixture near_ground() {
    FilterFixture fixture = selftest::filter_fixture(Ground::noise);
    Vertices& v = fixture.scene.vertices;
    constexpr float half_width = 2, far = 8, texels_per_unit = 60;
    const std::array<glm::vec2, 4> corners{
        {{-half_width, 0}, {half_width, 0}, {half_width, far}, {-half_width, far}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        v.position_world[i] = {corners[i].x, 0, -corners[i].y};
        v.uv[0][i] = glm::vec2{0.0263f, 0.0134f} + corners[i] * (texels_per_unit / 128);
    }
    fixture.view.width = 256, fixture.view.height = 256;
    const double pitch = 17 * std::numbers::pi / 180;
    fixture.view.camera = look_at({0, 1, 0}, {0, 1 - std::sin(pitch), -std::cos(pitch)}, {0, 1, 0});
    fixture.view.camera.window = symmetric_window(std::numbers::pi / 6, 1);
    fixture.view.camera.near_depth = 0.05;
    fixture.frame = rasterizer::render(fixture.scene, fixture.view);
    return fixture;
}

const FilterFixture& noise() {
    static const FilterFixture fixture = near_ground();
    return fixture;
}

Picture drawn(const FilterFixture& fixture, const texture::Method& method) {
    return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                {.method = method, .options = {}});
}

JointConformance joint(const texture::Method& method, const std::string& name) {
    const FilterClaim claim{.method = name, .precision = hardware};
    const Picture picture = drawn(noise(), method);
    std::cout << "    " << selftest::in_words(selftest::conformance_of(picture, noise(), claim)) << "\n";
    const JointConformance found = joint_conformance_of(picture, noise(), claim);
    for (const std::string& line : in_words(found)) std::cout << "    " << line << "\n";
    return found;
}

const Lattice eight{8, Rounding::nearest}, eight_down{8, Rounding::down};

TEST(Joint, RoundedToNearestKeepsThePromise) {
    const auto found =
        joint(limited_trilinear({.lod = eight, .weights = eight, .blend = eight}), "trilinear-gl");
    EXPECT_FALSE(found.leaves_promise());
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
    for (int round = 0; round < 12; ++round) {
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

TEST(Joint, AnEllipseOfEightBitsKeepsThePromise) {
    for (const Lattice& weights : {eight, eight_down})
        EXPECT_FALSE(joint(limited_ellipse({.weights = weights}), "ewa-pbrt").leaves_promise());
}

}  // namespace
}  // namespace zproof
