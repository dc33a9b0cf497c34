/// Elementary functions of intervals. Each end is taken in double and moved outwards by more than the
/// function's error: glibc's are good to 2 ulp (GNU C Library manual, "Errors in Math Functions"), and one
/// step here is 2^-50 of the value.
#pragma once

#include "math/interval.h"

namespace zproof {

namespace detail {

inline Interval stepped_outward(double low, double high) {
    constexpr double step = 0x1p-50, least = std::numeric_limits<double>::denorm_min();
    return {low - (std::abs(low) * step + least), high + (std::abs(high) * step + least)};
}

}  // namespace detail

inline double middle(const Interval& a) { return a.low() + (a.high() - a.low()) / 2; }
/// Half the width, and the middle's own rounding.
inline double radius(const Interval& a) {
    const double m = middle(a);
    return std::max(a.high() - m, m - a.low()) * (1 + 0x1p-50);
}

inline Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.low(), b.low()), std::max(a.high(), b.high())};
}
/// All numbers within `by` >= 0 of it.
inline Interval widen(const Interval& a, double by) {
    return by == 0 ? a : Interval{a.low(), a.high()} + Interval{-by, by};
}
inline Interval larger(const Interval& a, const Interval& b) {
    return {std::max(a.low(), b.low()), std::max(a.high(), b.high())};
}
inline Interval smaller(const Interval& a, const Interval& b) {
    return {std::min(a.low(), b.low()), std::min(a.high(), b.high())};
}
/// The interval clamped like std::clamp, end by end.
inline Interval clamped(const Interval& a, double low, double high) {
    return {std::clamp(a.low(), low, high), std::clamp(a.high(), low, high)};
}

inline Interval square(const Interval& a) {
    const Interval m = magnitude(a);
    return m * m;
}
/// The square root of what the interval holds at or above 0.
inline Interval square_root(const Interval& a) {
    return clamped(
        detail::stepped_outward(std::sqrt(std::max(a.low(), 0.0)), std::sqrt(std::max(a.high(), 0.0))), 0,
        std::numeric_limits<double>::infinity());
}
inline Interval length(const Interval& a, const Interval& b) { return square_root(square(a) + square(b)); }

/// The low end is -inf where `a` may be 0.
inline Interval log2(const Interval& a) {
    return detail::stepped_outward(std::log2(std::max(a.low(), 0.0)), std::log2(std::max(a.high(), 0.0)));
}
inline Interval exp2(const Interval& a) {
    return detail::stepped_outward(std::exp2(a.low()), std::exp2(a.high()));
}
inline Interval exp(const Interval& a) {
    return detail::stepped_outward(std::exp(a.low()), std::exp(a.high()));
}

}  // namespace zproof
