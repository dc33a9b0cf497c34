#include "compare/bounds/triangle_bounds.h"

namespace zproof {

LocalBounds TriangleBounds::at(double inverse_depth, double gradient) const {
    return BoundsOnPlane(*this, gradient).at(inverse_depth);
}

BoundsOnPlane::BoundsOnPlane(const TriangleBounds& b, double gradient)
    : corners_(b.nearest, b.farthest),
      eps_px_(b.eps_base_px, b.eps_per_inverse_depth, gradient, corners_.highest),
      depth_eps_px_(b.depth_eps_base_px, b.depth_eps_per_inverse_depth, gradient, corners_.highest),
      depth_factor_(b.depth_factor),
      depth_share_(b.depth_share),
      plane_offset_(b.plane_offset),
      everywhere_{.depth_absolute = b.depth_absolute,
                  .inverse_depth_error = b.inverse_depth_error,
                  .inverse_depth_bias = b.inverse_depth_bias} {}

}  // namespace zproof
