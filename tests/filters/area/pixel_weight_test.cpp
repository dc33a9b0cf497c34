// The mean under weights of more than a pixel against integrals in one dimension, and by brute force.
#include "filters/area/pixel_weight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracle/pictures.h"
#include "tests/oracle/scenes_at_random.h"
#include "texture/linear_image.h"
#include "textured_plane.h"
#include "weight_at.h"

namespace zproof::oracle {
namespace {

/// A separable filter as its source has it.
struct Filter {
    Reconstruction reconstruction;
    double half_side;
    double (*at)(double x);
    double affine_error;  ///< of a mean where texture coordinates are affine; found, and far below the bound
};

/// Mitchell and Netravali (1988), equation (8).
double mitchell(double x) {
    constexpr double b = 1.0 / 3, c = 1.0 / 3;
    const double d = std::abs(x), d2 = d * d, d3 = d2 * d;
    if (d >= 2) return 0;
    return d < 1 ? ((12 - 9 * b - 6 * c) * d3 + (-18 + 12 * b + 6 * c) * d2 + 6 - 2 * b) / 6
                 : ((-b - 6 * c) * d3 + (6 * b + 30 * c) * d2 + (-12 * b - 48 * c) * d + 8 * b + 24 * c) / 6;
}

/// Harris (1978), table 1, the minimum four-term window of 92 dB; 3 px, as in OpenImageIO and, by default, in
/// Cycles.
double blackman_harris(double x) {
    if (std::abs(x) > 1.5) return 0;
    const double turn = 2 * std::numbers::pi * (x + 1.5) / 3;
    return 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) - 0.01168 * std::cos(3 * turn);
}

/// Gauss's rule of degree 5 on parts between places in ascending order: exact where a cubic meets a patch.
template <class F>
double integral(std::vector<double> places, const F& f) {
    constexpr int parts = 16;
    const double node = std::sqrt(0.6);
    std::ranges::sort(places);
    double sum = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double h = (places[i] - places[i - 1]) / (2 * parts);
        for (int k = 0; k < parts; ++k) {
            const double x = places[i - 1] + (2 * k + 1) * h;
            sum += h / 9 * (5 * f(x - node * h) + 8 * f(x) + 5 * f(x + node * h));
        }
    }
    return sum;
}

/// Where the filter is not smooth, up to x.
std::vector<double> breaks(const Filter& filter, double x = 2) {
    std::vector<double> places;
    for (int i = -2; i <= 2; ++i) places.push_back(std::min(i * filter.half_side / 2, x));
    return places;
}

double total(const Filter& filter) { return integral(breaks(filter), filter.at); }

class SeparableWeight : public testing::TestWithParam<Filter> {};
INSTANTIATE_TEST_SUITE_P(PixelWeight, SeparableWeight,
                         testing::Values(Filter{Reconstruction::mitchell, 2, mitchell, 1e-12},
                                         Filter{Reconstruction::blackman_harris, 1.5, blackman_harris,
                                                1e-9}));

TEST_P(SeparableWeight, IsItsSources) {
    const Filter& filter = GetParam();
    const area::PixelWeight& weight = area::weight_of(filter.reconstruction);
    EXPECT_EQ(weight.half_side, filter.half_side);
    for (double x = -filter.half_side; x < filter.half_side; x += 0.0703125)
        for (const double y : {-0.9, 0.0, 1.25})
            EXPECT_NEAR(area::weight_at(weight, x, y), filter.at(x) * filter.at(y), 1e-15) << x << " " << y;
    EXPECT_NEAR(weight.total, total(filter) * total(filter), weight.error);
}

/// Of functions of a place, the mean of draws' weights times values is the weighted mean.
TEST_P(SeparableWeight, IsDrawnInProportion) {
    const Filter& filter = GetParam();
    const area::PixelWeight& weight = area::weight_of(filter.reconstruction);
    constexpr int n = 512;
    double one = 0, left = 0, squares = 0, greatest = 0;
    for (int i = 0; i < n * n; ++i) {
        const area::Draw draw = weight.drawn((glm::dvec2(i % n, i / n) + 0.5) / double(n));
        one += draw.weight;
        left += draw.offset_px.x < 0.3 ? draw.weight : 0;
        squares += draw.weight * draw.offset_px.y * draw.offset_px.y;
        greatest = std::max(greatest, std::abs(draw.weight));
        ASSERT_GE(draw.weight * area::weight_at(weight, draw.offset_px.x, draw.offset_px.y), 0);
    }
    const auto square = [&](double y) { return filter.at(y) * y * y; };
    EXPECT_NEAR(one / (n * n), 1, 1e-11);
    EXPECT_NEAR(left / (n * n), integral(breaks(filter, 0.3), filter.at) / total(filter), 1.5 / n);
    EXPECT_NEAR(squares / (n * n), integral(breaks(filter), square) / total(filter), 1e-3);
    EXPECT_LE(greatest, weight.greatest_draw);
    EXPECT_GE(greatest, 0.9999 * weight.greatest_draw);
}

/// To the left of an edge, white: the mean is the filter's integral up to the edge.
TEST_P(SeparableWeight, OfAnEdgeIsTheFiltersIntegral) {
    const Filter& filter = GetParam();
    constexpr int width = 9;
    const AreaTruth truth = area_truth(scene_of({{0.3f, -400, -1}, {0.3f, 400, -1}, {-800, 0, -1}}),
                                       unit_pixels(width, 3), filter.reconstruction);
    double least = 1, greatest = 0;
    for (int x = 0; x < width; ++x) {
        const double edge =
            std::clamp(width / 2.0 + double(0.3f) - (x + 0.5), -filter.half_side, filter.half_side);
        EXPECT_NEAR(truth.mean.at(x, 1).r, integral(breaks(filter, edge), filter.at) / total(filter),
                    filter.affine_error)
            << x;
        least = std::min(least, truth.mean.at(x, 1).r);
        greatest = std::max(greatest, truth.mean.at(x, 1).r);
        const bool is_cut = std::abs(edge) < filter.half_side;
        EXPECT_EQ(truth.kind.at(x, 1), is_cut     ? TruthKind::silhouette
                                       : edge > 0 ? TruthKind::interior
                                                  : TruthKind::background);
    }
    // Weights below 0 carry the picture beyond the edge's colours, and nothing cuts it back.
    if (filter.reconstruction == Reconstruction::mitchell) {
        EXPECT_LT(least, -0.002);
        EXPECT_GT(greatest, 1.01);
    }
}

/// From straight above the texture is not distorted. A pixel is `texels_per_px` wide.
Scene straight_ground(Image image, double texels_per_px, int height, const glm::dvec2& offset = {0.3, 0.71}) {
    const double px = 2 * std::tan(std::numbers::pi / 6) / height;
    const int side = image.width;
    return textured_plane(
        64, {.image = std::move(image), .per_unit = texels_per_px / (px * side), .offset = offset});
}

TEST_P(SeparableWeight, OfTexelsStraightAheadIsAProductOfSums) {
    const Filter& filter = GetParam();
    constexpr int side = 16, columns = 7;
    const View view = ground_view(side, side, 90);
    for (const double texels_per_px : {0.13, 0.77, 7.3, 20.3, 70.1}) {
        const Scene scene = straight_ground(noise(columns, columns, 3), texels_per_px, side);
        const texture::LinearImage image = texture::linear_image({columns, columns, scene.images[0].texels});
        // The share of each texel of the endless line in a pixel's mean; the pixel's middle is at `u`.
        const auto shares = [&](double u) {
            std::vector<double> sums(columns);
            const int reach = int(filter.half_side * texels_per_px) + 2;
            for (int k = int(std::floor(u)) - reach; k <= int(std::floor(u)) + reach; ++k) {
                std::vector<double> places = breaks(filter);
                for (const double texel : {k - 0.5, k + 0.5, k + 1.5})
                    places.push_back(
                        std::clamp((texel - u) / texels_per_px, -filter.half_side, filter.half_side));
                sums[std::size_t((k % columns + columns) % columns)] += integral(places, [&](double x) {
                    return filter.at(x) * std::max(0.0, 1 - std::abs(u + texels_per_px * x - k - 0.5));
                });
            }
            for (double& sum : sums) sum /= total(filter);
            return sums;
        };
        const AreaTruth truth = area_truth(scene, view, filter.reconstruction);
        double worst = 0;
        for (int y = 0; y < side; y += 3)
            for (int x = 1; x < side; x += 2) {
                const auto across = shares(0.3 * columns + texels_per_px * (x + 0.5 - side / 2.0));
                const auto down = shares(0.71 * columns + texels_per_px * (y + 0.5 - side / 2.0));
                double mean = 0;
                for (int row = 0; row < columns; ++row)
                    for (int column = 0; column < columns; ++column)
                        mean += double(image.at(column, row).r) * across[std::size_t(column)] *
                                down[std::size_t(row)];
                ASSERT_EQ(truth.kind.at(x, y), TruthKind::interior);
                worst = std::max(worst, std::abs(mean - truth.mean.at(x, y).r));
            }
        // Whole texels smaller than 1/8 px take rules that are good enough, and no better.
        EXPECT_LT(worst, texels_per_px < 8 ? filter.affine_error : truth.half_width.at(1, 0))
            << texels_per_px;
    }
}

/// A patch seen at a slant, by Gauss's rule in two dimensions: 1 / W varies, nothing else is amiss.
TEST_P(SeparableWeight, OfAPatchInPerspectiveIsWithinItsBound) {
    const Filter& filter = GetParam();
    constexpr int width = 32, height = 24;
    constexpr double per_unit = 0.01, slant = 20 * std::numbers::pi / 180;
    const Scene scene = textured_plane(
        64, {.image = image_of(2, 2, {0, 255, 200, 20}), .per_unit = per_unit, .offset = {0.5, 0.7}});
    const texture::LinearImage image = texture::linear_image({2, 2, scene.images[0].texels});
    const AreaTruth truth = area_truth(scene, ground_view(width, height, 20), filter.reconstruction);
    const auto colour = [&](double x, double y) {
        const double px = 2 * std::tan(std::numbers::pi / 6) / height;
        const double right = (x - width / 2.0) * px, up = (height / 2.0 - y) * px;
        const double distance = 1 / (std::sin(slant) - up * std::cos(slant));
        const double s = 2 * (per_unit * distance * right + 0.5) - 0.5,
                     t = 2 * (0.7 - per_unit * distance * (std::cos(slant) + up * std::sin(slant))) - 0.5;
        EXPECT_TRUE(s > 0 && s < 1 && t > 0 && t < 1) << s << " " << t;
        const auto texel = [&](int column, int row) { return double(image.at(column, row).r); };
        return (1 - t) * ((1 - s) * texel(0, 0) + s * texel(1, 0)) +
               t * ((1 - s) * texel(0, 1) + s * texel(1, 1));
    };
    for (int y = 10; y < height; y += 3)
        for (const int x : {3, 16}) {
            const double mean = integral(breaks(filter), [&](double v) {
                return filter.at(v) * integral(breaks(filter), [&](double u) {
                           return filter.at(u) * colour(x + 0.5 + u, y + 0.5 + v);
                       });
            });
            ASSERT_EQ(truth.kind.at(x, y), TruthKind::interior);
            EXPECT_NEAR(truth.mean.at(x, y).r, mean / (total(filter) * total(filter)),
                        1e-10 + truth.half_width.at(x, y))
                << x << " " << y;
        }
}

/// Texels 0 and 1 side by side, 24 px apart: between their centres, a ramp.
TEST_P(SeparableWeight, OfARampIsItsMiddle) {
    constexpr int side = 12;
    const AreaTruth truth = area_truth(straight_ground(image_of(2, 1, {0, 255}), 1.0 / 24, side, {0.5, 0.5}),
                                       ground_view(side, side, 90), GetParam().reconstruction);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            EXPECT_NEAR(truth.mean.at(x, y).r, 0.5 + (x + 0.5 - side / 2.0) / 24, GetParam().affine_error)
                << x << " " << y;
}

class EveryWeight : public testing::TestWithParam<NamedReconstruction> {};
INSTANTIATE_TEST_SUITE_P(PixelWeight, EveryWeight, testing::ValuesIn(reconstructions),
                         [](const auto& named) { return std::string{named.param.letters}; });

TEST_P(EveryWeight, LeavesAConstantWhatItIs) {
    const Scene scene = textured_plane(64, {.image = image_of(2, 2, {90, 90, 90, 90}), .per_unit = 0.31});
    const float grey = texture::linear_image({2, 2, scene.images[0].texels}).at(0, 0).r;
    const AreaTruth truth = area_truth(scene, ground_view(24, 18, 25), GetParam().reconstruction);
    int interior = 0;
    for (std::size_t i = 0; i < truth.mean.pixels().size(); ++i) {
        if (truth.kind.pixels()[i] != TruthKind::interior) continue;
        ++interior;
        EXPECT_NEAR(truth.mean.pixels()[i].r, double(grey), 1e-8);
    }
    EXPECT_GT(interior, 200);
}

/// Samples that all meet one colour may still have missed what weighs as much as three of them. Of fewer than
/// 4096 that is more than 0.001.
TEST_P(EveryWeight, HasAnIntervalAsWideAsItsGreatestDrawAsks) {
    const AreaTruth samples =
        sampled_area_truth(scene_of(wall(2)), unit_pixels(5, 4), GetParam().reconstruction);
    const double greatest = area::weight_of(GetParam().reconstruction).greatest_draw;
    for (std::size_t i = 0; i < samples.mean.pixels().size(); ++i) {
        EXPECT_NEAR(samples.mean.pixels()[i].r, 1, 1e-12);
        EXPECT_NEAR(samples.half_width.pixels()[i], 3 * greatest / 4096, 1e-12);
    }
}

}  // namespace
}  // namespace zproof::oracle
