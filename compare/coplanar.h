#pragma once

#include "compare/bounds.h"

namespace zproof {

/// Do both triangles lie in one plane, exactly?
bool coplanar(const CornersWorld& a, const CornersWorld& b);

}  // namespace zproof
