/// What a stochastic texture filter may show at a pixel, and how likely: what its definition says of one
/// sample.
#pragma once

#include <array>
#include <vector>

#include "frame/colour_range.h"
#include "math/interval.h"

namespace zproof {

/// In how many ways probabilities can be off together: the place lies farther along u; along v; the LOD is
/// larger; the decisions along u and v depend on each other.
inline constexpr std::size_t draw_tilts = 4;

struct ColourDraw {
    Interval probability;
    ColourRange colour;
    std::array<double, draw_tilts> tilt{};  ///< change of the probability by each; need not be exact
};

/// A pixel is the mean of this many independent draws. Probabilities sum to 1.
struct ColourDraws {
    int samples = 1;
    std::vector<ColourDraw> draws;
};

}  // namespace zproof
