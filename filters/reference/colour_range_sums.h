/// Arithmetic of colour ranges. Rounding of these sums is not in them: FilterReference charges it once, at
/// the end.
#pragma once

#include "filters/reference/permitted_colours.h"
#include "math/interval_functions.h"

namespace zproof::oracle::filter_reference {

inline ColourRange hull(const ColourRange& a, const ColourRange& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

inline ColourRange operator+(const ColourRange& a, const ColourRange& b) {
    return {a.low + b.low, a.high + b.high};
}

inline ColourRange operator*(const Interval& weight, const ColourRange& a) {
    const glm::dvec3 p = weight.low() * a.low, q = weight.low() * a.high, r = weight.high() * a.low,
                     s = weight.high() * a.high;
    return {glm::min(glm::min(p, q), glm::min(r, s)), glm::max(glm::max(p, q), glm::max(r, s))};
}

inline ColourRange around(const glm::dvec3& middle, const glm::dvec3& radius) {
    return {middle - radius, middle + radius};
}

/// (1 - share) a + share b for every share of the interval: the ends hold the extremes, since it is affine in
/// the share.
inline ColourRange blended(const ColourRange& a, const ColourRange& b, const Interval& share) {
    const auto at = [&](double s) { return Interval{1 - s} * a + Interval{s} * b; };
    return hull(at(share.low()), at(share.high()));
}

}  // namespace zproof::oracle::filter_reference
