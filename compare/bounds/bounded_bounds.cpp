#include "compare/bounds/bounded_bounds.h"

#include <cmath>

namespace zproof {

BoundedBounds::BoundedBounds(const ViewFacts& facts, const BoundedPrecision& precision)
    : precision_(precision) {
    depth_absolute_ = precision.depth_absolute + depth_of_range(facts.view.camera, precision.depth_of_range);
}

TriangleBounds BoundedBounds::of(const ViewFacts& facts, const TriangleExtent&) const {
    const Camera& c = facts.view.camera;
    TriangleBounds bounds;
    bounds.eps_base_px = bounds.depth_eps_base_px = precision_.eps_px;
    bounds.depth_absolute = depth_absolute_;
    bounds.depth_share = precision_.depth_relative;
    // a depth t, told as t + r |t| + a at most, is held against near and far
    const double share = compounded(precision_.depth_relative);
    const auto slack = [&](double depth) {
        if (!std::isfinite(depth)) return 0.0;
        return std::isfinite(share) ? std::abs(depth) * share + depth_absolute_ * (1 + share) : unlimited;
    };
    bounds.near_slack = slack(c.near_depth);
    bounds.far_slack = slack(c.far_depth);
    return bounds;
}

}  // namespace zproof
