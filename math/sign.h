#pragma once

namespace zproof {

/// -1, 0 or +1 of a plain double, for estimates only: a verdict asks an Interval or a Rational. NaN gives 0.
inline int sign(double a) { return (a > 0) - (a < 0); }

inline bool is_certainly_zero(double a) { return a == 0; }

inline double magnitude(double a) { return a < 0 ? -a : a; }

}  // namespace zproof
