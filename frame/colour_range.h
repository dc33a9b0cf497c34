/// Colours between two bounds, channel by channel: what a filter's definition permits at a pixel.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace zproof {

/// Linear light; low <= high.
struct ColourRange {
    glm::dvec3 low{0}, high{0};
};

/// The ranges of the permitted colours. Where a decision is undecided (which texel is nearest), each outcome
/// has a range of its own; a colour is admissible where one of them holds all its channels. Never empty.
using PermittedColours = std::vector<ColourRange>;

}  // namespace zproof
