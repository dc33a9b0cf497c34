#pragma once

#include <cmath>

#include "compare/bounds/triangle_extent.h"

namespace zproof {

/// Do both triangles lie in one plane, exactly?
bool coplanar(const CornersWorld& a, const CornersWorld& b);

/// Do three points lie on one line, exactly? True where two of them are the same.
bool collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The direction of a segment, either way round, as one number and the most that it errs by. It is a quotient
/// of two linear forms of the direction, which collinear segments share.
struct Slope {
    double value, error;
};

Slope slope_of(const glm::vec3& a, const glm::vec3& b);

/// Do the segments certainly lie on two lines?
inline bool are_turned(const Slope& a, const Slope& b) {
    return std::abs(a.value - b.value) > a.error + b.error;
}

}  // namespace zproof
