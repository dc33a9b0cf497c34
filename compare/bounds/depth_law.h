/// What may be said of a triangle's depth by one renderer, all over the image.
#pragma once

#include <limits>
#include <vector>

namespace zproof {

/// What TriangleDepth::at and certainly_holds need of one triangle and one renderer, as plain numbers. Only
/// for triangles whose plane and depth errors are finite; where a renderer does not keep to its corners'
/// depths, `nearest` and `farthest` are infinite.
template <class Number>
struct DepthLawOf {
    Number nearness_per_x, nearness_per_y, nearness_offset;  ///< of pixel indices
    Number gradient, own_error;
    Number least, highest;                  ///< nearness
    Number base, per, most, amplification;  ///< of a Displacement
    Number depth_factor, plane_offset, absolute, nearness_error;
    Number relative;  ///< of depth, where plane_offset is 0: depth_factor compounded
    Number nearest, farthest;
};
using DepthLaw = DepthLawOf<double>;

/// A ratio that says: ask for this pixel by itself.
inline constexpr double unsettled = -1;

/// A law by which every depth is unsettled.
inline constexpr DepthLaw law_of_nothing = [] {
    DepthLaw law{};
    law.depth_factor = 1;
    law.relative = std::numeric_limits<double>::infinity();
    return law;
}();

/// The laws of the same triangles for both renderers, by place. What both laws of a triangle say of its plane
/// is the same.
struct LawsOfBoth {
    std::vector<DepthLaw> candidate, reference;
};

}  // namespace zproof
