#include "texture/point_filters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace zproof::texture {
namespace {

/// Grey code 10 * column + row in a 4 x 3 image.
class PointFilters : public testing::Test {
  protected:
    PointFilters() {
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) {
                const auto grey = std::uint8_t(10 * column + row);
                codes.insert(codes.end(), {grey, grey, grey, 255});
            }
    }
    Texels texels() const { return {4, 3, codes}; }
    static double grey(int column, int row) { return linear_from_srgb(std::uint8_t(10 * column + row)); }

    std::vector<std::uint8_t> codes;
};

TEST_F(PointFilters, DecodeTheSrgbCurve) {
    EXPECT_EQ(linear_from_srgb(0), 0);
    EXPECT_EQ(linear_from_srgb(255), 1);
    EXPECT_NEAR(linear_from_srgb(188), 0.5029, 1e-4);  // 18 % grey and half white are the usual landmarks
    EXPECT_NEAR(linear_from_srgb(118), 0.1812, 1e-4);
}

TEST_F(PointFilters, BothHitTheTexelAtItsCentre) {
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) {
            const glm::dvec2 centre{(column + 0.5) / 4, (row + 0.5) / 3};
            EXPECT_EQ(nearest(texels(), {}, centre).r, grey(column, row));
            EXPECT_NEAR(bilinear(texels(), {}, centre).r, grey(column, row), 1e-15);
        }
}

TEST_F(PointFilters, BilinearIsTheMeanHalfWayBetween) {
    const double mean = (grey(1, 1) + grey(2, 1) + grey(1, 2) + grey(2, 2)) / 4;
    EXPECT_NEAR(bilinear(texels(), {}, {0.5, 2.0 / 3}).g, mean, 1e-15);
}

TEST_F(PointFilters, WrapAsTheyAreTold) {
    const int beyond[3] = {-1, 4, 9};
    const int repeat[3] = {3, 0, 1}, clamp[3] = {0, 3, 3}, mirror[3] = {0, 3, 1};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(wrapped(Wrap::repeat, beyond[i], 4), repeat[i]);
        EXPECT_EQ(wrapped(Wrap::clamp_to_edge, beyond[i], 4), clamp[i]);
        EXPECT_EQ(wrapped(Wrap::mirrored_repeat, beyond[i], 4), mirror[i]);
    }
    const double seam = (grey(3, 1) + grey(0, 1)) / 2;
    EXPECT_NEAR(bilinear(texels(), {Wrap::repeat, Wrap::repeat}, {1, 0.5}).r, seam, 1e-15);
    EXPECT_NEAR(bilinear(texels(), {Wrap::clamp_to_edge, Wrap::repeat}, {1, 0.5}).r, grey(3, 1), 1e-15);
}

TEST_F(PointFilters, TakeAnyCoordinate) {
    for (const double strange : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300}) {
        EXPECT_TRUE(std::isfinite(bilinear(texels(), {}, {strange, 0.5}).r));
        EXPECT_TRUE(std::isfinite(nearest(texels(), {}, {0.5, strange}).r));
    }
}

TEST_F(PointFilters, OfAConstantTextureAreConstant) {
    std::ranges::fill(codes, std::uint8_t{77});
    for (double x = -2; x < 2; x += 0.37)
        EXPECT_NEAR(bilinear(texels(), {Wrap::mirrored_repeat, Wrap::clamp_to_edge}, {x, 1.3 * x}).b,
                    linear_from_srgb(77), 1e-16);
}

}  // namespace
}  // namespace zproof::texture
