// Moments over a box against numbers worked out by hand and against sums texel by texel.
#include "filters/stored/box_moments.h"

#include <gtest/gtest.h>

#include "math/rounding.h"
#include "tests/support/footprints.h"

namespace zproof::texture {
namespace {

/// Texels 0, 0, 1, 1.
MomentTables two_and_two() {
    LinearImage image = constant_image(4, 1, glm::vec4{0});
    image.at(2, 0) = image.at(3, 0) = glm::vec4{1};
    return {image, {Wrap::repeat, Wrap::repeat}, SatStorage::integer};
}

/// Three texels, of which two are 1: mean 2/3, variance 2/3 - 4/9. With half of the second one: 2 of 2.5.
TEST(BoxMoments, AreThoseOfTheTexelsInTheBox) {
    const Moments three = two_and_two().over({1, 4}, {0, 1});
    EXPECT_NEAR(three.mean.r, 2 / 3.0, unit_roundoff_float64);
    EXPECT_NEAR(three.variance.r, 2 / 9.0, 4 * unit_roundoff_float64);
    const Moments cut = two_and_two().over({1.5, 4}, {0, 1});
    EXPECT_NEAR(cut.mean.r, 0.8, unit_roundoff_float64);
    EXPECT_NEAR(cut.variance.r, 0.16, 4 * unit_roundoff_float64);
    EXPECT_EQ(two_and_two().over({2, 4}, {0, 1}).variance.r, 0);
}

TEST(BoxMoments, OfTwoValuesReachChebyshevsBound) {
    for (double low = 0; low < 1.9; low += 0.37) {
        const Moments found = two_and_two().over({low, 4}, {0, 1});
        EXPECT_NEAR(most_at_or_above(found.mean.r, found.variance.r, 1), 2 / (4 - low), 1e-14) << low;
    }
    EXPECT_EQ(most_at_or_above(0.5, 0.01, 0.5), 1);
    EXPECT_EQ(most_at_or_above(0.5, 0, 0.6), 0);
}

/// Squares are rounded to float32 and to multiples of 2^-35; the mean square is at most 1.
TEST(BoxMoments, AreThoseOfEveryTexel) {
    const LinearImage image = random_image(19, 11, 6);
    const MomentTables tables{image, {Wrap::repeat, Wrap::repeat}, SatStorage::integer};
    for (int left = 0; left < 18; left += 3)
        for (int top = 0; top < 10; top += 2) {
            double sum = 0, squares = 0;
            const double count = (19 - left) * (11 - top);
            for (int row = top; row < 11; ++row)
                for (int column = left; column < 19; ++column) {
                    const double texel = double(image.at(column, row).g);
                    sum += texel / count, squares += texel * texel / count;
                }
            const Moments found = tables.over({double(left), 19}, {double(top), 11});
            EXPECT_NEAR(found.mean.g, sum, 0x1p-36 + 1e-13);
            EXPECT_NEAR(found.variance.g, squares - sum * sum, 0x1p-24 + 3 * 0x1p-36);
        }
}

}  // namespace
}  // namespace zproof::texture
