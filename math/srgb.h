/// The sRGB transfer function (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>

namespace zproof {

/// The code value, 0 to 1, of linear light cut to [0, 1]; NaN stays NaN.
inline double encoded_srgb(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// The linear light of a code value, 0 to 1.
inline double decoded_srgb(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

}  // namespace zproof
