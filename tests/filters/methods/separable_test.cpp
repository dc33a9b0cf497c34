// Methods of four texels along either axis, by weights worked by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "filters/methods/catalogue.h"
#include "math/rounding.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

Footprint at(double u, double v) { return flat_footprint({u, v}, {0.5, 0}, {0, 0.5}); }

/// Weights of the columns 1 to 4 of an image of 8 x 8; the row may be any.
std::array<double, 4> column_weights(const char* name, double u) {
    std::array<double, 4> weights{};
    for (const Tap& tap : find_method(name)->prepare(random_image(8, 8, 1), {}).taps(at(u, 3.7)))
        weights.at(std::size_t(tap.column - 1)) += tap.weight;
    return weights;
}

void expect_weights(const char* name, double u, const std::array<double, 4>& expected) {
    const std::array<double, 4> found = column_weights(name, u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << name << " at " << u;
}

/// At a texel's centre, 2.5, and halfway to the next.
TEST(Separable, WeighsAsItsCardsSay) {
    for (const char* name : {"bspline", "bspline-bilinear", "smart-bicubic"}) {
        expect_weights(name, 2.5, {1 / 6.0, 4 / 6.0, 1 / 6.0, 0});
        expect_weights(name, 3, {1 / 48.0, 23 / 48.0, 23 / 48.0, 1 / 48.0});
    }
    expect_weights("bicubic", 2.5, {0, 1, 0, 0});
    expect_weights("bicubic", 3, {-1 / 16.0, 9 / 16.0, 9 / 16.0, -1 / 16.0});
    expect_weights("lanczos2", 2.5, {0, 1, 0, 0});
    // sinc(1/2) sinc(1/4) and sinc(3/2) sinc(3/4) are as nine to minus one.
    expect_weights("lanczos2", 3, {-1 / 16.0, 9 / 16.0, 9 / 16.0, -1 / 16.0});
    const double one = std::exp(-2.0) - std::exp(-8.0), none = 1 - std::exp(-8.0), sum = 2 * one + none;
    expect_weights("gaussian", 2.5, {one / sum, none / sum, one / sum, 0});
}

/// Sigg and Hadwiger's four reads, to rounding: places up to 300 texels out.
TEST(Separable, FourBilinearReadsAreTheSixteenTexels) {
    const LinearImage image = random_image(37, 22, 3);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const FilterOptions options{.addressing = {wrap, wrap}};
        const Sampler sixteen = find_method("bspline")->prepare(image, options),
                      four = find_method("bspline-bilinear")->prepare(image, options);
        for (std::uint32_t seed = 0; seed < 300; ++seed) {
            const Footprint f = random_footprint(seed);
            const glm::dvec4 difference = glm::abs(sixteen.colour(f) - four.colour(f));
            for (int c = 0; c < 4; ++c) EXPECT_LE(difference[c], 4096 * unit_roundoff_float64) << seed;
        }
    }
}

/// LOD 1/2: half of it the B-spline in level 0, half bilinear in level 1; from LOD 1 on trilinear.
TEST(Separable, SmartBicubicReadsLevel0ByTheBSpline) {
    const LinearImage image = random_image(16, 16, 3);
    const Sampler smart = find_method("smart-bicubic")->prepare(image, {});
    const std::vector<Tap> taps = smart.taps(flat_footprint({5.3, 6.1}, {std::sqrt(2.0), 0}, {0, 1}));
    ASSERT_EQ(taps.size(), 20u);
    double finest = 0;
    for (const Tap& tap : taps) finest += tap.image == 0 ? tap.weight : 0;
    EXPECT_NEAR(finest, 0.5, 1e-14);
    const Footprint coarse = flat_footprint({5.3, 6.1}, {3, 0}, {0, 1});
    const glm::dvec4 difference =
        smart.colour(coarse) - find_method("trilinear-gl")->prepare(image, {}).colour(coarse);
    EXPECT_LE(glm::length(difference), 64 * unit_roundoff_float64);
}

}  // namespace
}  // namespace zproof::texture
