#include "math/lazy_rational.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace zproof {
namespace {

/// A number twice: worked out lazily, and at once.
struct Both {
    LazyRational lazy;
    Rational exact;
};

Both operator-(const Both& a) { return {-a.lazy, -a.exact}; }
Both operator+(const Both& a, const Both& b) { return {a.lazy + b.lazy, a.exact + b.exact}; }
Both operator-(const Both& a, const Both& b) { return {a.lazy - b.lazy, a.exact - b.exact}; }
Both operator*(const Both& a, const Both& b) { return {a.lazy * b.lazy, a.exact * b.exact}; }
Both operator/(const Both& a, const Both& b) { return {a.lazy / b.lazy, a.exact / b.exact}; }
Both of(double value) { return {LazyRational(value), Rational(value)}; }

void expect_same(const Both& number) {
    EXPECT_EQ(sign(number.lazy), sign(number.exact));
    EXPECT_EQ(is_certainly_zero(number.lazy), is_certainly_zero(number.exact));
    EXPECT_EQ(magnitude(number.lazy).value(), magnitude(number.exact));
    EXPECT_EQ(number.lazy.value(), number.exact);
}

/// Each the result of some before it, a few of them 0 without double precision's knowing.
TEST(LazyRational, HasTheSignAndTheValueOfRationals) {
    std::mt19937 random(1);
    const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
    int zeros = 0;
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        std::vector<Both> numbers{of(0.1), of(1e-30), of(-3), of(1.0 / 3), of(1e200)};
        while (numbers.size() < 25) {
            const Both a = numbers[below(numbers.size())], b = numbers[below(numbers.size())];
            const std::size_t operation = below(6);
            if (operation == 0) numbers.push_back(-a);
            if (operation == 1) numbers.push_back(a + b);
            if (operation == 2) numbers.push_back(a - b);
            if (operation == 3) numbers.push_back(a * b);
            if (operation == 4 && sign(b.exact) != 0) numbers.push_back(a / b);
            if (operation == 5 && sign(b.exact) != 0) numbers.push_back(a / b * b - a);
        }
        for (const Both& number : numbers) {
            expect_same(number);
            zeros += sign(number.exact) == 0;
        }
    }
    EXPECT_GT(zeros, 300);
}

TEST(LazyRational, GoesOnWhereDoublesOverflow) {
    const Both huge = of(1e300);
    expect_same(huge * huge - huge * huge);
    expect_same(huge * huge / huge);
    expect_same(of(1) / (huge * huge));
}

/// A sign that was asked for stays what it was, whatever is made of the number afterwards.
TEST(LazyRational, IsSharedByItsCopies) {
    const LazyRational one_third = LazyRational(1) / LazyRational(3);
    const std::array third{one_third, one_third};
    EXPECT_EQ(sign(third[0] * LazyRational(3) - LazyRational(1)), 0);
    EXPECT_EQ(third[1].value(), Rational(1) / Rational(3));
    EXPECT_EQ((third[0] + third[1]).value(), Rational(2) / Rational(3));
}

}  // namespace
}  // namespace zproof
