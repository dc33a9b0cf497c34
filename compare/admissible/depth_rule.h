/// Is a depth within its bound? The one place that says so (docs/bounds.md).
#pragma once

#include "compare/admissible/neighbourhood.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

/// A renderer's depth at one pixel held against the bound of its own id.
struct DepthCheck {
    DepthBound bound;
    double error_over_bound = 0;
    bool is_admissible = false;
};

/// `triangle` must be the depth of the triangle with these corners, by these bounds. In double; by exact
/// arithmetic where that does not suffice.
DepthCheck check_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                       const TriangleDepth& triangle, const PixelCoord& place, float depth);

}  // namespace zproof
