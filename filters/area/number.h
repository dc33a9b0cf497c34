/// What the clipping asks of a number beside arithmetic.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/rational.h"

namespace zproof::oracle::area {

/// The greatest whole number that is not greater; |a| < 2^62.
inline std::int64_t floor_of(double a) { return std::int64_t(std::floor(a)); }

inline std::int64_t floor_of(const Rational& a) {
    const auto numerator = boost::multiprecision::numerator(a),
               denominator = boost::multiprecision::denominator(a);
    const auto quotient = std::int64_t(numerator / denominator);  // towards 0
    return quotient * denominator > numerator ? quotient - 1 : quotient;
}

}  // namespace zproof::oracle::area
