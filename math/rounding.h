/// Units of rounding: what one floating-point operation may cost.
#pragma once

#include <cassert>

namespace zproof {

inline constexpr double unit_roundoff_float32 = 0x1p-24;  ///< u of IEEE binary32, round to nearest
inline constexpr double unit_roundoff_float64 = 0x1p-53;  ///< u of IEEE binary64, round to nearest

/// gamma_k = k u / (1 - k u): the relative error bound of k chained roundings (Higham 2002, Lemma 3.1).
/// Valid for k u < 1.
constexpr double gamma(int k, double unit_roundoff) {
    const double ku = k * unit_roundoff;
    assert(ku < 1);
    return ku / (1 - ku);
}

}  // namespace zproof
