/// The bounds of a ray caster (docs/bounds.md, "A ray caster").
#pragma once

#include <array>

#include "compare/bounds/aim.h"
#include "compare/bounds/triangle_bounds.h"
#include "frame/precision.h"

namespace zproof {

/// Woop: the absolute errors of the three weights, added up. Sizes are sums of absolute coordinates: of the
/// corners from the ray's origin, and of its direction.
double sheared_weights_error(const std::array<double, 3>& corners, double direction, double unit);

class RayBounds {
  public:
    RayBounds(const ViewFacts& facts, const RayPrecision& precision);

    TriangleBounds of(const ViewFacts& facts, const TriangleExtent& extent) const;
    /// Is the depth that is shown the distance that was compared?
    bool has_depth_of_distance() const { return precision_.hit_point == HitPoint::distance; }
    double background_eps_px() const { return aim_.px; }

  private:
    /// Where rays of this aim meet the plane of a triangle of that size, by t = (v0 . n) / (d . n).
    TriangleBounds on_plane(const ViewFacts& facts, const TriangleSize& size) const;
    std::array<double, 3> edges_px(const ViewFacts& facts, const TriangleExtent& extent) const;
    /// What the triangle's rounded corners move in the image, px times depth.
    double corners_px_times_depth(const ViewFacts& facts, const TriangleExtent& extent) const;
    double tolerance_px_times_depth(const ViewFacts& facts, const TriangleExtent& extent) const;
    void add_world_error(TriangleBounds& bounds, const ViewFacts& facts) const;
    bool may_be_missed(const ViewFacts& facts, const TriangleExtent& extent) const;

    RayPrecision precision_;
    double unit_;
    Aim aim_;
    double depth_absolute_;  ///< scene units: of the aim, and the share of far - near
};

}  // namespace zproof
