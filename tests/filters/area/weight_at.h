// A weight at one place, from its factors along the axes.
#pragma once

#include <algorithm>
#include <cmath>

#include "filters/area/pixel_weight.h"

namespace zproof::oracle::area {

/// Offsets from the pixel's centre. Of the squares that a pixel has along an axis, the first counts for it as
/// the last of the square's pixels.
inline double weight_at(const PixelWeight& weight, double x, double y) {
    const auto along = [&](double offset) {
        const double from_first = offset + weight.half_side;
        const double square = std::clamp(std::floor(from_first), 0.0, weight.across - 1.0);
        const double place = from_first - square - 0.5;
        AxisWeights factors;
        weight.along({&place, 1}, &factors);
        return factors[std::size_t(weight.across - 1 - int(square))];
    };
    if (weight.along == nullptr) return 1;
    const double above_rim = along(x) * along(y) - weight.at_rim;
    return weight.at_rim > 0 ? std::max(above_rim, 0.0) : above_rim;
}

}  // namespace zproof::oracle::area
