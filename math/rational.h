/// Exact rational numbers: the last word on a sign.
#pragma once

#include <boost/multiprecision/gmp.hpp>

namespace zproof {

/// Every finite double converts without loss.
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// -1, 0 or +1; never undecided.
inline int sign(const Rational& a) { return a.sign(); }

inline bool is_certainly_zero(const Rational& a) { return a.sign() == 0; }

inline Rational magnitude(const Rational& a) { return a.sign() < 0 ? Rational(-a) : a; }

}  // namespace zproof
