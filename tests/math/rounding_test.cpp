#include "math/rounding.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/rational.h"

namespace zproof {
namespace {

TEST(UnitRoundoff, IsHalfTheStepAboveOne) {
    EXPECT_EQ(2 * unit_roundoff_float32, double(std::numeric_limits<float>::epsilon()));
    EXPECT_EQ(2 * unit_roundoff_float64, std::numeric_limits<double>::epsilon());
}

TEST(Gamma, OfNoRoundingIsZero) { EXPECT_EQ(gamma(0, unit_roundoff_float32), 0); }

TEST(Gamma, IsKuOverOneMinusKu) {
    EXPECT_EQ(gamma(1, 0.25), 1.0 / 3);
    EXPECT_EQ(gamma(3, 0.25), 3);
    EXPECT_DOUBLE_EQ(gamma(8, unit_roundoff_float32), 8 * 0x1p-24 / (1 - 8 * 0x1p-24));
}

// Higham 2002, Lemma 3.1: the worst k factors (1 + u), or k divisors (1 - u) of which all but one are exact.
TEST(Gamma, BoundsAChainOfKRoundings) {
    for (const double unit : {unit_roundoff_float32, unit_roundoff_float64, 0x1p-8})
        for (int k = 1; k <= 32; ++k) {
            Rational up(1), down(1);
            for (int i = 0; i < k; ++i) {
                up = up * (Rational(1) + Rational(unit));
                down = down * (Rational(1) - Rational(unit));
            }
            EXPECT_LE(up - Rational(1), Rational(gamma(k, unit)));
            EXPECT_LE(Rational(1) - down, Rational(gamma(k, unit)));
        }
}

}  // namespace
}  // namespace zproof
