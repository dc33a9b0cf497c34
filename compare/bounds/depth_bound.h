/// Depths that a faultless renderer may report at one pixel.
#pragma once

#include <cmath>
#include <limits>

#include "scenes/camera.h"

namespace zproof {

/// A bound where nothing is known.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Camera depths [low, high], and the true depth at the pixel's centre.
struct DepthBound {
    double low = 0, truth = 0, high = 0;  ///< all NaN where the answer is background

    bool is_open() const { return low <= 0 && high == unlimited; }  ///< Does it say nothing?
};

/// Inverse depths: 1 / depth for perspective, -depth for parallel projections.
struct InverseDepthRange {
    double least, greatest;
};
inline constexpr InverseDepthRange any_inverse_depth{-unlimited, unlimited};
inline double inverse_depth_of(double depth, Projection projection) {
    return projection == Projection::perspective ? 1 / depth : -depth;
}

/// |depth - truth| over the bound on that side; 0 for an exact hit, and where nothing bounds it; NaN for NaN.
inline double error_over_bound(const DepthBound& bound, double depth) {
    const double error = std::abs(depth - bound.truth);
    const double room = depth < bound.truth ? bound.truth - bound.low : bound.high - bound.truth;
    const double share = error / room;
    return depth == bound.truth || (std::isinf(room) && depth == depth) ? 0 : share;
}

}  // namespace zproof
