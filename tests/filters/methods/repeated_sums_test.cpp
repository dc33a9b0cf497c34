// Repeated integration (Heckbert 1986) against sums texel by texel, and against numbers worked out by hand.
#include "filters/stored/repeated_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/methods/catalogue.h"
#include "math/rounding.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat};

std::vector<std::int64_t> numbers(int size, std::uint32_t seed) {
    Rng rng{seed};
    std::vector<std::int64_t> all;
    for (int i = 0; i < size; ++i) all.push_back(std::int64_t(rng.between(-100, 100)));
    return all;
}

/// The runs' sums, summed again by definition: D_n(k) = D_(n-1)(k) + ... + D_(n-1)(k + side - 1).
std::int64_t summed(const std::vector<std::int64_t>& line, Wrap wrap, std::int64_t k, int side, int order) {
    if (order == 0) return line[std::size_t(wrapped(wrap, k, int(line.size())))];
    std::int64_t sum = 0;
    for (int i = 0; i < side; ++i) sum += summed(line, wrap, k + i, side, order - 1);
    return sum;
}

TEST(RepeatedAxis, RunsAreWholeMultiplesOfStoredSums) {
    for (const Wrap wrap : wraps)
        for (const int order : {2, 3})
            for (const int size : {1, 2, 3, 7}) {
                const std::vector<std::int64_t> line = numbers(size, std::uint32_t(size));
                const RepeatedAxis axis{wrap, size, order};
                std::vector<std::int64_t> stored;
                for (int i = 0; i < axis.stored(); ++i)
                    stored.push_back(line[std::size_t(wrapped(wrap, i, size))]);
                for (int time = 0; time < order; ++time)
                    for (std::size_t i = 1; i < stored.size(); ++i) stored[i] += stored[i - 1];
                for (std::int64_t first = -30; first < 30; ++first)
                    for (const int side : {1, 2, 5, 8}) {
                        std::int64_t sum = 0;
                        for (const SumTerm& term : axis.runs(first, side))
                            sum += term.times * stored.at(std::size_t(term.index));
                        EXPECT_EQ(sum, summed(line, wrap, first, side, order))
                            << "wrap " << int(wrap) << ", order " << order << ", size " << size << ", first "
                            << first << ", side " << side;
                    }
            }
}

/// Columns alike: one texel of 1 in column 5 of 16.
LinearImage one_column() {
    LinearImage image = constant_image(16, 16, glm::vec4{0});
    for (int row = 0; row < 16; ++row) image.at(5, row) = glm::vec4{1};
    return image;
}

double seen_at(const char* name, double u, double step) {
    const Sampler sampler = find_method(name)->prepare(one_column(), {});
    return sampler.colour(flat_footprint({u, 8}, {step, 0}, {0, step})).r;
}

/// w = 4: the triangle (1 - |x| / 4) / 4, integrated over the texel that lies 0, 2 and 4 texels away.
TEST(RepeatedIntegration, WeighsATexelByTheTriangleOverIt) {
    const double step = 4 * std::sqrt(2.0);
    EXPECT_NEAR(seen_at("triangle-sat", 5.5, step), 15 / 64.0, 1e-15);
    EXPECT_NEAR(seen_at("triangle-sat", 7.5, step), 1 / 8.0, 1e-15);
    EXPECT_NEAR(seen_at("triangle-sat", 9.5, step), 1 / 128.0, 1e-15);
    EXPECT_EQ(seen_at("triangle-sat", 10.5, step), 0);
}

/// w = 4: 2 (x / 8) (3/4 - x^2 / 3) at x = 1/8, times 4 / 4; and ((3/2 - 7/8)^3 - (3/2 - 9/8)^3) / 6.
TEST(RepeatedIntegration, WeighsATexelByTheQuadraticBSplineOverIt) {
    const double step = 4 * std::sqrt(3.0);
    EXPECT_NEAR(seen_at("quadratic-sat", 5.5, step), 143 / 768.0, 1e-15);
    EXPECT_NEAR(seen_at("quadratic-sat", 9.5, step), 49 / 1536.0, 1e-15);
    EXPECT_NEAR(seen_at("quadratic-sat", 1.5, step), 49 / 1536.0, 1e-15);
}

/// 3.5 sqrt(2) is 4 rounded half up, and anything below is 3: (1 - 1 / 12) / 3 over the texel itself.
TEST(RepeatedIntegration, RoundsTheWidthToWholeTexels) {
    EXPECT_NEAR(seen_at("triangle-sat", 5.5, 3.501 * std::sqrt(2.0)), 15 / 64.0, 1e-15);
    EXPECT_NEAR(seen_at("triangle-sat", 5.5, 3.499 * std::sqrt(2.0)), 11 / 36.0, 1e-15);
}

/// One box of one texel more on the squares of the texels: the cubic B-spline.
TEST(RepeatedIntegration, OfOneTexelAndOrderThreeIsTheCubicBSpline) {
    const LinearImage image = random_image(21, 13, 4);
    for (const Wrap wrap : wraps) {
        const FilterOptions options{.addressing = {wrap, wrap}};
        const Sampler repeated = find_method("quadratic-sat")->prepare(image, options),
                      spline = find_method("bspline")->prepare(image, options);
        for (double u = -40; u < 60; u += 0.37) {
            const Footprint f = flat_footprint({u, 0.61 * u}, {0.3, 0.1}, {-0.1, 0.3});
            const glm::dvec4 difference = glm::abs(repeated.colour(f) - spline.colour(f));
            // Texels are rounded to multiples of 2^-35; places of 60 texels are rounded once or twice.
            for (int c = 0; c < 4; ++c) EXPECT_LE(difference[c], 0x1p-36 + 256 * unit_roundoff_float64) << u;
        }
    }
}

/// Of a long axis sums reach 2^31 an order 3; nothing of that is in the error.
TEST(RepeatedIntegration, KeepsAConstantHoweverLongTheAxis) {
    const LinearImage image = constant_image(2048, 3, glm::vec4{0.25f, 0.5f, 1, 0.75f});
    for (const char* name : {"triangle-sat", "quadratic-sat"})
        for (const Wrap wrap : wraps) {
            const Sampler sampler = find_method(name)->prepare(image, {.addressing = {wrap, wrap}});
            for (const double size : {0.5, 3.0, 100.0, 5000.0, 1e9})
                for (const double u : {2040.3, -7000.1, 1e12}) {
                    const glm::dvec4 colour = sampler.colour(flat_footprint({u, 1.2}, {size, 0}, {0, size}));
                    for (int c = 0; c < 4; ++c)
                        EXPECT_NEAR(colour[c], double(image.texels[0][c]), 64 * unit_roundoff_float64)
                            << name << ", " << size << ", " << u << ", wrap " << int(wrap);
                }
        }
}

TEST(RepeatedIntegration, ReadsOneSumPerEndAndPlaceOfTheSpline) {
    const LinearImage image = random_image(256, 256, 4);
    const Footprint f = flat_footprint({120.3, 130.7}, {20, 0}, {0, 30});
    EXPECT_EQ(find_method("triangle-sat")->prepare(image, {}).taps(f).size(), 81u);
    EXPECT_EQ(find_method("quadratic-sat")->prepare(image, {}).taps(f).size(), 256u);
}

TEST(RepeatedIntegration, TakesAnyFootprint) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const char* name : {"triangle-sat", "quadratic-sat"})
        for (const Wrap wrap : wraps) {
            const Sampler sampler =
                find_method(name)->prepare(random_image(16, 24, 4), {.addressing = {wrap, wrap}});
            for (const double strange : {0.0, std::nan(""), infinity, -infinity, 1e300, -1e300, 1e-300, 1e9})
                for (int place = 0; place < 6; ++place) {
                    Footprint f = flat_footprint({3, 5}, {2, 1}, {-1, 3});
                    double* const places[] = {&f.per_x.x, &f.per_x.y,  &f.per_y.x,
                                              &f.per_y.y, &f.centre.x, &f.centre.y};
                    *places[place] = strange;
                    const std::vector<Tap> taps = sampler.taps(f);
                    EXPECT_GE(taps.size(), 1u);
                    EXPECT_LE(taps.size(), 4096u);
                    for (const Tap& tap : taps) {
                        ASSERT_TRUE(tap.column >= 0 && tap.column < sampler.stored[0].width);
                        ASSERT_TRUE(tap.row >= 0 && tap.row < sampler.stored[0].height);
                    }
                }
        }
}

}  // namespace
}  // namespace zproof::texture
