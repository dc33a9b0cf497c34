/// What sums that are stored in doubles may cost a box's mean, wherever the box lies.
#include "filters/reference/box_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace zproof::oracle::filter_reference {
namespace {

constexpr int size = 16;

/// Codes of 8 bits, so that the reference's own sums are exact but for their multiple.
texture::LinearImage some_image() {
    std::mt19937 random{5};
    texture::LinearImage image{size, size, {}};
    for (int i = 0; i < size * size; ++i) {
        const float value = float(random() % 256) / 256;
        image.texels.emplace_back(value, value, value, 1.0f);
    }
    return image;
}

/// An implementation that takes its sums where the box lies: up to (u, v), periods and all.
double plain_sum(const texture::LinearImage& image, double u, double v) {
    const auto up_to = [&](double across, double down) {
        double sum = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                sum += double{image.at(column, row).r} * std::clamp(across - column, 0.0, 1.0) *
                       std::clamp(down - row, 0.0, 1.0);
        return sum;
    };
    const double tiles_u = std::floor(u / size), tiles_v = std::floor(v / size);
    const double within_u = u - tiles_u * size, within_v = v - tiles_v * size;
    return tiles_u * tiles_v * up_to(size, size) + tiles_u * up_to(size, within_v) +
           tiles_v * up_to(within_u, size) + up_to(within_u, within_v);
}

double plain_mean(const texture::LinearImage& image, const glm::dvec2& low, const glm::dvec2& high) {
    const double sum = plain_sum(image, high.x, high.y) - plain_sum(image, low.x, high.y) -
                       plain_sum(image, high.x, low.y) + plain_sum(image, low.x, low.y);
    return sum / ((high.x - low.x) * (high.y - low.y));
}

/// How far a mean in doubles lies from the middle of what is permitted, in half widths: the largest.
double worst_slack(double tiles) {
    const texture::LinearImage image = some_image();
    const BoxMean means{image, {}, {0, 0}};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> place{0, size}, side{1, 4};
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 low = glm::dvec2{place(random), place(random)} + tiles * size,
                         high = low + glm::dvec2{side(random), side(random)};
        const ColourRange range = means.over(
            {Interval{low.x}, Interval{high.x}, Interval{low.y}, Interval{high.y}}, FilterPrecision{});
        const double middle = (range.low.r + range.high.r) / 2, half = (range.high.r - range.low.r) / 2;
        worst = std::max(worst, std::abs(plain_mean(image, low, high) - middle) / half);
    }
    return worst;
}

TEST(BoxMean, PermitsSumsInDoublesManyPeriodsAway) {
    for (const double tiles : {0.0, 30.0, 300.0, 3000.0}) {
        const double worst = worst_slack(tiles);
        std::cout << "    " << tiles << " periods away: " << worst << "\n";
        EXPECT_LE(worst, 1);
    }
}

}  // namespace
}  // namespace zproof::oracle::filter_reference
