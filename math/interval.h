/// Closed intervals of doubles that contain the exact result, and the exception that says "ask exact
/// rationals".
///
/// Where both operands are single numbers and double precision holds the result exactly, it is a single
/// number as well (error-free transformations: Dekker 1971, Knuth TAOCP 4.2.2). Every other operation rounds
/// outwards by one relative step of 2^-52 without touching the rounding mode, so results are the same bits
/// everywhere. An overflow gives NaN or infinite ends, which decide nothing. What times the number 0 is 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace zproof {

/// Thrown where the sign of a number decides, and double precision cannot tell it.
struct UndecidedSign {};

class Interval {
  public:
    constexpr Interval(double exact = 0) : low_(exact), high_(exact) {}
    constexpr Interval(double low, double high) : low_(low), high_(high) {}

    constexpr double low() const { return low_; }
    constexpr double high() const { return high_; }

    friend Interval operator-(Interval a) { return {-a.high_, -a.low_}; }
    friend Interval operator+(Interval a, Interval b) {
        const double sum = a.low_ + b.low_;
        if (a.is_number() && b.is_number() && is_exact_sum(a.low_, b.low_, sum)) return sum;
        return outward(sum, a.high_ + b.high_);
    }
    friend Interval operator-(Interval a, Interval b) { return a + -b; }
    friend Interval operator*(Interval a, Interval b) {
        const double p = a.low_ * b.low_, q = a.low_ * b.high_, r = a.high_ * b.low_, s = a.high_ * b.high_;
        if (a.is_number() && b.is_number() && is_exact_product(a.low_, b.low_, p)) return p;
        if ((a.is_zero() || b.is_zero()) && std::isfinite(p + q + r + s)) return 0;
        return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
    }
    /// Throws UndecidedSign where b may be 0.
    friend Interval operator/(Interval a, Interval b) {
        if (!(b.low_ > 0) && !(b.high_ < 0)) throw UndecidedSign{};
        const double quotient = a.low_ / b.low_;
        if (a.is_number() && b.is_number() && is_exact_product(quotient, b.low_, a.low_)) return quotient;
        return a * outward(1 / b.high_, 1 / b.low_);
    }

  private:
    constexpr bool is_number() const { return low_ == high_; }
    constexpr bool is_zero() const { return low_ == 0 && high_ == 0; }
    /// The rounding error of a sum is a double; NaN after an overflow.
    static bool is_exact_sum(double a, double b, double sum) {
        const double b_held = sum - a;
        return (a - (sum - b_held)) + (b - b_held) == 0;
    }
    /// The rounding error of a product is a double where it does not underflow. Without fma(), which is a
    /// call where a program must run on processors that lack it; factors beyond 2^996 overflow, and are not
    /// exact.
    static bool is_exact_product(double a, double b, double product) {
        constexpr double least = 0x1p-900;
        const bool holds_its_error = std::abs(product) > least || a == 0 || b == 0;
        const double a_upper = upper_half(a), a_lower = a - a_upper;
        const double b_upper = upper_half(b), b_lower = b - b_upper;
        const double left = ((product - a_upper * b_upper) - a_lower * b_upper) - a_upper * b_lower;
        return holds_its_error && a_lower * b_lower == left;
    }
    /// The leading 26 bits (Dekker 1971).
    static double upper_half(double x) {
        const double shifted = x * (0x1p27 + 1);
        return shifted - (shifted - x);
    }
    /// x minus (plus) |x| 2^-52 is at or beyond the next double, since ulp(x) <= |x| 2^-52. What underflowed
    /// is within the least denormal number; a larger step keeps what follows out of their range, where
    /// processors take a hundred times as long.
    static Interval outward(double low, double high) {
        constexpr double step = 0x1p-52, least = 0x1p-960;
        return {low - (std::abs(low) * step + least), high + (std::abs(high) * step + least)};
    }

    double low_, high_;
};

/// -1, 0 or +1. Throws UndecidedSign where the interval holds 0 and another number, or NaN.
inline int sign(Interval a) {
    if (a.low() > 0) return 1;
    if (a.high() < 0) return -1;
    if (a.low() == 0 && a.high() == 0) return 0;
    throw UndecidedSign{};
}

/// Never undecided: false where it may be another number.
inline bool is_certainly_zero(const Interval& a) { return a.low() == 0 && a.high() == 0; }

/// The absolute value of every number that the interval holds; never undecided.
inline Interval magnitude(const Interval& a) {
    if (a.low() >= 0) return a;
    if (a.high() <= 0) return -a;
    return {0, std::max(-a.low(), a.high())};
}

}  // namespace zproof
