#include "compare/bounds/triangle_bounds.h"

namespace zproof {

TriangleBounds bounds_of(const DepthTerms& terms) {
    TriangleBounds bounds;
    bounds.eps_base_px = bounds.depth_eps_base_px = terms.eps_base_px;
    bounds.eps_per_inverse_depth = bounds.depth_eps_per_inverse_depth = terms.eps_per_inverse_depth;
    bounds.depth_factor = terms.factor;
    bounds.depth_share = terms.share;
    bounds.depth_absolute = terms.absolute;
    bounds.inverse_depth_error = terms.inverse_depth_error;
    bounds.plane_offset = terms.plane_offset;
    bounds.inverse_depth_bias = terms.inverse_depth_bias;
    return bounds;
}

LocalBounds TriangleBounds::at(double inverse_depth, double gradient) const {
    return BoundsOnPlane(*this, gradient).at(inverse_depth);
}

BoundsOnPlane::BoundsOnPlane(const TriangleBounds& b, double gradient)
    : corners_(b.nearest, b.farthest),
      eps_px_(b.eps_base_px, b.eps_per_inverse_depth, gradient, corners_.highest),
      depth_eps_px_(b.depth_eps_base_px, b.depth_eps_per_inverse_depth, gradient, corners_.highest),
      depth_factor_(b.depth_factor),
      plane_offset_(b.plane_offset),
      depth_relative_(compounded(b.depth_factor) + b.depth_share),
      depth_absolute_(b.depth_absolute),
      inverse_depth_error_(b.inverse_depth_error),
      inverse_depth_bias_(b.inverse_depth_bias) {}

}  // namespace zproof
