/// Lookups that read several places along a line.
#pragma once

#include "filters/reference/levels.h"

namespace zproof::oracle::filter_reference {

/// The ellipse's longer axis as a unit vector; which of its two ends is not said. Anything where the ellipse
/// may be a circle.
TexelInterval major_direction(const PixelFootprint& footprint);

/// Whole numbers that rounding upwards may give of what the interval holds, within [1, most].
std::vector<int> ceilings(const Interval& a, int most);

/// A tap: how far along the line, in lengths of `along`, and its weight.
struct LineTap {
    Interval at, weight;
};

/// The weighted mean of a read at each tap; weights are divided by their sum.
///     |sum w c / sum w - m| <= sum |w - w0| |c - m| / sum w   with m the mean by the weights' middles w0
ColourRange mean_along(const TexelInterval& centre, const TexelInterval& along,
                       const std::vector<LineTap>& taps,
                       const std::function<ColourRange(const TexelInterval&)>& read);

/// What weights known within intervals make of colours: see mean_along. No weight is below 0, so that a mean
/// lies among the colours; at least one is above 0.
ColourRange weighted_mean(const std::vector<Interval>& weights, const std::vector<ColourRange>& colours);

}  // namespace zproof::oracle::filter_reference
