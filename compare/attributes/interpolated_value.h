/// The rule of interpolated values: may a faultless renderer give them? (docs/bounds.md, "Attributes")
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compare/attributes/interpolation_errors.h"
#include "compare/attributes/surface.h"
#include "compare/attributes/wrong_attribute.h"

namespace zproof {

/// Values between two ends.
struct ValuesBetween {
    double low, high;

    bool holds(double value) const { return value >= low && value <= high; }
};

/// One number of an attribute at a pixel, and what it interpolates.
struct InterpolatedValue {
    std::size_t channel;
    float value;
    std::array<double, 3> at_corners;
    double slack;            ///< what arithmetic may do to one that is taken in the square
    double slack_at_centre;  ///< to the one at the pixel's centre; below 0 where that is none
    ValuesBetween means;     ///< of the corners' values, as computed
};

InterpolatedValue interpolated_value(const Surface& surface, const InterpolationErrors& errors,
                                     std::size_t channel, const std::array<double, 3>& at_corners,
                                     float value);

/// A surface, and how values may have been taken from it.
struct SampledSurface {
    const Surface& surface;
    InterpolationErrors errors;
    double depth;  ///< that the frame shows
    std::array<const ViewBounds*, 2>
        depth_bounds;  ///< of that depth, and of one that is interpolated like values

    double half_side() const { return surface.seen.bounds.depth_eps_px; }
};

/// The first wrong one of an attribute's values; nothing where they are admissible. In double with an error
/// bound, then in intervals, then in rationals.
std::optional<WrongAttribute> first_wrong(const SampledSurface& surface,
                                          const std::vector<InterpolatedValue>& values);

}  // namespace zproof
