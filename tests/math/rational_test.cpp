#include "math/rational.h"

#include <gtest/gtest.h>

#include <cmath>

#include "doubles.h"

namespace zproof {
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// m 2^e from a double's own parts.
Rational from_parts(double value) {
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    const Integer power = Integer(1) << unsigned(std::abs(exponent));
    return exponent >= 0 ? Rational(Integer(digits * power)) : Rational(Integer(digits), power);
}

TEST(Rational, FromADoubleIsExact) {
    for (const double value : hard_doubles())
        ASSERT_EQ(Rational(value), from_parts(value)) << std::hexfloat << value;
    std::mt19937_64 random(1);
    for (int i = 0; i < 10'000; ++i) {
        const double value = random_double(random);
        ASSERT_EQ(Rational(value), from_parts(value)) << std::hexfloat << value;
    }
}

TEST(Rational, KeepsWhatDoublesLose) {
    EXPECT_NE(Rational(0.1) + Rational(0.2), Rational(0.3));
    EXPECT_EQ((Rational(1e300) + Rational(1e-300)) - Rational(1e300), Rational(1e-300));
    EXPECT_EQ(Rational(1e-300) * Rational(1e-300) / Rational(1e-300), Rational(1e-300));
    EXPECT_EQ(Rational(1) / Rational(3.0) * Rational(3.0), Rational(1));
}

TEST(Rational, SignIsNeverUndecided) {
    EXPECT_EQ(sign(Rational(0)), 0);
    EXPECT_EQ(sign(Rational(-0.0)), 0);
    EXPECT_EQ(sign(Rational(5e-324)), 1);
    EXPECT_EQ(sign(Rational(-5e-324) * Rational(5e-324)), -1);
    EXPECT_EQ(sign(Rational(0.1) + Rational(0.2) - Rational(0.3)), 1) << "0.1 + 0.2 lies above 0.3's double";
}

}  // namespace
}  // namespace zproof
