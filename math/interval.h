/// Closed intervals of doubles that contain the exact result, and the exception that says "ask exact
/// rationals".
///
/// Every operation rounds outwards by one relative step of 2^-52 without touching the rounding mode, so
/// results are the same bits everywhere. An overflow gives NaN or infinite ends, which decide nothing.
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
    friend Interval operator+(Interval a, Interval b) { return outward(a.low_ + b.low_, a.high_ + b.high_); }
    friend Interval operator-(Interval a, Interval b) { return outward(a.low_ - b.high_, a.high_ - b.low_); }
    friend Interval operator*(Interval a, Interval b) {
        const double p = a.low_ * b.low_, q = a.low_ * b.high_, r = a.high_ * b.low_, s = a.high_ * b.high_;
        return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
    }
    /// Throws UndecidedSign where b may be 0.
    friend Interval operator/(Interval a, Interval b) {
        if (!(b.low_ > 0) && !(b.high_ < 0)) throw UndecidedSign{};
        return a * outward(1 / b.high_, 1 / b.low_);
    }

  private:
    /// x minus (plus) |x| 2^-52 is at or beyond the next double, since ulp(x) <= |x| 2^-52.
    static Interval outward(double low, double high) {
        constexpr double step = 0x1p-52, least = std::numeric_limits<double>::denorm_min();
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

/// Of every number that the interval holds; never undecided.
inline Interval magnitude(const Interval& a) {
    if (a.low() >= 0) return a;
    if (a.high() <= 0) return -a;
    return {0, std::max(-a.low(), a.high())};
}

}  // namespace zproof
