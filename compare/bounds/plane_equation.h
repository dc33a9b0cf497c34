/// What it costs to interpolate depth by a plane equation in float32 (docs/bounds.md, "A z-buffer").
#pragma once

#include <span>
#include <vector>

#include "compare/bounds/triangle_extent.h"
#include "scenes/view.h"

namespace zproof {

/// A corner as the depth buffer sees it: raster position in px, and reversed z in [0, 1].
struct WindowCorner {
    double x = 0, y = 0, z = 0;
};

/// The part of a triangle between near and far that the window shows, with a corner wherever clipping makes
/// one; at most 9, in order around it, fewer than 3 where nothing is left.
std::vector<WindowCorner> window_polygon(const View& view, const TriangleExtent& extent);

/// How far corners move before depth is interpolated.
struct CornerShift {
    double snap_px = 0;   ///< onto the sub-pixel grid, which plane equations need not follow
    double drift_px = 0;  ///< by rounding
};

/// Errors of a plane equation anywhere on the triangle. z_error is unlimited where three corners may lie on a
/// line or nothing of the triangle is left.
struct PlaneEquationBounds {
    double z_error = 0;  ///< of the depth buffer's z
    double spread = 1;   ///< largest sum of |barycentrics| on what the snapped triangle covers
};

/// The worst of any three corners of the polygon: however it is cut into triangles, they are among them.
/// `width` and `height` are the image's.
PlaneEquationBounds plane_equation_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                          const View& view);

/// Depth-buffer z per unit of inverse depth.
double z_per_inverse_depth(const Camera& camera);

}  // namespace zproof
