/// What a texture filter's definition permits at a pixel: ranges of colours, and of a stochastic filter how
/// likely each is for one sample.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "math/interval.h"

namespace zproof {

/// Linear light; low <= high.
struct ColourRange {
    glm::dvec3 low{0}, high{0};
};

/// The ranges of the permitted colours. Where a decision is undecided (which texel is nearest), each outcome
/// has a range of its own; a colour is admissible where one of them holds all its channels. Never empty.
using PermittedColours = std::vector<ColourRange>;

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
