/// The bounds of a ray caster (docs/bounds.md, "A ray caster").
#pragma once

#include <array>

#include "compare/bounds/aim.h"
#include "compare/bounds/triangle_bounds.h"
#include "frame/precision.h"

namespace zproof {

/// The absolute errors of the three weights by which a test tells where it hits, added up. `v` are the
/// corners from a point that lies at most `origin_abs` aside of the ray's origin along each axis.
double weights_error(const RayPrecision& precision, const std::array<glm::dvec3, 3>& v,
                     const glm::dvec3& origin_abs, const glm::dvec3& direction_abs);

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
    /// What erring weights make of a mean of the corners' depths or distances; perspective: as a share of it.
    double mean_error(const ViewFacts& facts, const TriangleExtent& extent, double volume) const;
    void add_world_error(TriangleBounds& bounds, const ViewFacts& facts) const;
    bool may_be_missed(const ViewFacts& facts, const TriangleExtent& extent) const;

    RayPrecision precision_;
    double unit_;
    Aim aim_;
    double depth_absolute_;  ///< scene units: of the aim, and the share of far - near
};

}  // namespace zproof
