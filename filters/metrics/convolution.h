/// Separable convolution of an image that is continued by its border pixels.
#pragma once

#include <vector>

#include "frame/plane.h"

namespace zproof {

/// Correlation with across x along: taps stand from -radius to radius, their number is odd.
Plane<double> convolved(const Plane<double>& values, const std::vector<double>& across,
                        const std::vector<double>& along);

/// The taps divided by their sum.
std::vector<double> normalised(std::vector<double> taps);

}  // namespace zproof
