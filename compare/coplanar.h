#pragma once

#include "compare/bounds.h"

namespace zproof {

/// Do both triangles lie in one plane, exactly?
bool coplanar(const CornersWorld& a, const CornersWorld& b);

/// Do three points lie on one line, exactly? True where two of them are the same.
bool collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace zproof
