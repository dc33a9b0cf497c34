/// The inverse depth that a faultless renderer may hold for a triangle at a pixel. An estimate in double of
/// numbers that are bounds themselves.
#pragma once

#include <algorithm>
#include <cmath>

#include "compare/bounds/bounds.h"
#include "compare/bounds/depth_bound.h"

namespace zproof {

/// The range that holds everything.
inline constexpr InverseDepthRange any_inverse_depth{-unlimited, unlimited};

/// A triangle's plane at a pixel.
struct PlaneHere {
    double inverse_depth, gradient;  ///< |d/dx| + |d/dy| per px
    double error;                    ///< of our own inverse depth; `unlimited` where the plane is not known
};

/// The plane's range over eps, clamped to the corners' inverse depths where the renderer keeps to them.
inline InverseDepthRange on_plane(const PlaneHere& plane, const LocalBounds& bounds,
                                  const InverseDepthRange& corners, bool keeps_to_corners) {
    const double shift =
        bounds.depth_eps_px * (plane.gradient + plane.error) + plane.error + bounds.inverse_depth_error;
    const double middle = plane.inverse_depth + bounds.inverse_depth_bias;
    const double low = middle - shift, high = middle + shift;
    const double least = std::clamp(low, corners.least, corners.greatest);
    const double greatest = std::clamp(high, least, corners.greatest);
    return {keeps_to_corners ? least : low, keeps_to_corners ? greatest : high};
}

/// The range widened by what rounding does to depth. Divisions come first; what they give is chosen
/// afterwards.
inline InverseDepthRange rounded(const InverseDepthRange& range, const LocalBounds& bounds,
                                 bool perspective) {
    const double r = bounds.depth_relative, a = bounds.depth_absolute;
    const double least_abs = std::abs(range.least), greatest_abs = std::abs(range.greatest);
    if (!perspective) return {range.least - least_abs * r - a, range.greatest + greatest_abs * r + a};
    const double share = r + a * greatest_abs;
    const double greatest = range.greatest + greatest_abs * share / (1 - share);
    return {range.least - least_abs * (r + a * least_abs), share < 1 ? greatest : unlimited};
}

}  // namespace zproof
