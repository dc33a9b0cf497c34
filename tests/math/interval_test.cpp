#include "math/interval.h"

#include <gtest/gtest.h>

#include <bit>
#include <optional>

#include "doubles.h"
#include "math/rational.h"

namespace zproof {
namespace {

/// Infinite and NaN ends exclude nothing.
bool holds(const Interval& i, const Rational& exact) {
    const bool above = !std::isfinite(i.low()) || Rational(i.low()) <= exact;
    return above && (!std::isfinite(i.high()) || exact <= Rational(i.high()));
}

std::optional<int> sign_or_undecided(const Interval& i) {
    try {
        return sign(i);
    } catch (const UndecidedSign&) {
        return std::nullopt;
    }
}

/// The results at the ends are the extremes of + - * / over two intervals.
template <class Operation>
void expect_enclosed(const Interval& a, const Interval& b, const Operation& operation) {
    const Interval result = operation(a, b);
    const std::optional<int> claimed = sign_or_undecided(result);
    for (const double x : {a.low(), a.high()})
        for (const double y : {b.low(), b.high()}) {
            const Rational exact = operation(Rational(x), Rational(y));
            ASSERT_TRUE(holds(result, exact)) << std::hexfloat << x << ' ' << y;
            ASSERT_EQ(claimed.value_or(exact.sign()), exact.sign()) << std::hexfloat << x << ' ' << y;
        }
}

bool holds_zero(const Interval& i) { return i.low() <= 0 && i.high() >= 0; }

void expect_all_enclosed(const Interval& a, const Interval& b) {
    expect_enclosed(a, b, [](const auto& x, const auto& y) { return x + y; });
    expect_enclosed(a, b, [](const auto& x, const auto& y) { return x - y; });
    expect_enclosed(a, b, [](const auto& x, const auto& y) { return x * y; });
    expect_enclosed(a, b, [](const auto& x, const auto&) { return -x; });
    if (!holds_zero(b)) expect_enclosed(a, b, [](const auto& x, const auto& y) { return x / y; });
}

Interval between(double a, double b) { return {std::min(a, b), std::max(a, b)}; }

TEST(Interval, EncloseEveryExactResultOfHardDoubles) {
    for (const double a : hard_doubles())
        for (const double b : hard_doubles()) expect_all_enclosed(a, b);
}

TEST(Interval, EncloseEveryExactResultOfRandomDoubles) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        expect_all_enclosed(random_double(random), random_double(random));
        expect_all_enclosed(random_double(random, -3, 3), random_double(random, -3, 3));
    }
}

TEST(Interval, EncloseEveryExactResultOfRandomIntervals) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE(i);
        const double a = random_double(random, -4, 4), b = random_double(random, -4, 4);
        const double c = random_double(random, -4, 4), d = random_double(random, -4, 4);
        expect_all_enclosed(between(a, b), between(c, d));
        expect_all_enclosed(between(random_double(random), a), between(random_double(random), c));
    }
}

TEST(Interval, ChainsOfOperationsStillEnclose) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE(i);
        Interval rounded = random_double(random, -5, 5);
        Rational exact(rounded.low());
        for (int step = 0; step < 8; ++step) {
            const double next = random_double(random, -5, 5);
            switch (random() % 4) {
                case 0:
                    rounded = rounded + next, exact = exact + Rational(next);
                    break;
                case 1:
                    rounded = rounded - next, exact = exact - Rational(next);
                    break;
                case 2:
                    rounded = rounded * next, exact = exact * Rational(next);
                    break;
                default:
                    rounded = rounded / next, exact = exact / Rational(next);
            }
            ASSERT_TRUE(holds(rounded, exact));
        }
    }
}

TEST(Interval, OfExactNumbersIsAFewUlpsWide) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 3000; ++i) {
        const Interval a = random_double(random, -9, 9), b = random_double(random, -9, 9);
        for (const Interval& r : {a * b, a / b, a + Interval(2) * a})
            EXPECT_LE(r.high() - r.low(), 0x1p-48 * std::abs(r.high()));
    }
}

bool is_a_number(const Interval& i) { return i.low() == i.high(); }

TEST(Interval, StaysANumberWhereDoubleHoldsTheResult) {
    const Interval three = 3, quarter = 0.25, tenth = 0.1;
    for (const Interval& exact : {three * quarter, three + quarter, three - quarter, quarter / Interval(-8),
                                  tenth + tenth, tenth - tenth, Interval(0) * tenth, three / three})
        EXPECT_TRUE(is_a_number(exact)) << exact.low();
    for (const Interval& rounded :
         {three * tenth, three + tenth, three - tenth, quarter / three, three / tenth})
        EXPECT_FALSE(is_a_number(rounded)) << rounded.low();
}

/// A random double of at most so many significant bits.
double short_double(std::mt19937_64& random, int bits) {
    const auto low_bits = ~std::uint64_t{0} << (53 - bits);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(random_double(random, -400, 400)) & low_bits);
}

TEST(Interval, OfAProductIsANumberExactlyWhereDoubleHoldsIt) {
    std::mt19937_64 random(5);
    std::size_t exact = 0;
    for (int i = 0; i < 20000; ++i) {
        const int bits = 20 + i % 34;
        const double a = short_double(random, bits), b = short_double(random, 53 - i % 40);
        const bool is_held = Rational(a) * Rational(b) == Rational(a * b);
        EXPECT_EQ(is_a_number(Interval(a) * Interval(b)), is_held) << a << ' ' << b;
        exact += is_held;
    }
    EXPECT_GT(exact, 3000u);
    EXPECT_LT(exact, 17000u);
}

TEST(Interval, DoesNotTakeAnUnderflowForAnExactResult) {
    const Interval tiny = 0x1p-600;
    EXPECT_FALSE(is_a_number(tiny * tiny));
    EXPECT_FALSE(is_a_number(Interval(0x1.8p-530) * Interval(0x1.8p-544)));
    EXPECT_FALSE(is_a_number(Interval(0x1p-1060) / Interval(0.75)));
}

TEST(Interval, OverflowDecidesNothing) {
    const Interval huge = 1e300, many = huge * huge;
    for (const Interval& i : {many, -many, many - many, many + many, many * Interval(-1),
                              many * Interval(-1, 1), -many * Interval(0, 1)})
        EXPECT_FALSE(sign_or_undecided(i)) << i.low() << ' ' << i.high();
}

TEST(Interval, DivisionByWhatMayBeZeroIsUndecided) {
    for (const Interval& zero :
         {Interval(0), Interval(-1, 1), Interval(0, 1), Interval(-1, 0), Interval(-0.0)})
        EXPECT_THROW(Interval(1) / zero, UndecidedSign);
}

TEST(Interval, SignIsUndecidedExactlyWhereZeroIsOneOfSeveralValues) {
    for (const double a : hard_doubles())
        for (const double b : hard_doubles()) {
            const Interval i = between(a, b);
            const std::optional<int> claimed = sign_or_undecided(i);
            const bool undecided = holds_zero(i) && i.low() != i.high();
            ASSERT_EQ(claimed.has_value(), !undecided) << a << ' ' << b;
            ASSERT_EQ(claimed.value_or(0), undecided ? 0 : (a > 0) - (a < 0));
        }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(sign_or_undecided(Interval(nan)));
    EXPECT_FALSE(sign_or_undecided(Interval(-1, nan)));
    EXPECT_FALSE(sign_or_undecided(Interval(nan, 1)));
}

}  // namespace
}  // namespace zproof
