/// The bounds of a z-buffer rasterizer (docs/bounds.md, "A rasterizer" and "A z-buffer").
#pragma once

#include <span>

#include "compare/bounds/depth_bound.h"
#include "compare/bounds/plane_equation.h"
#include "compare/bounds/roundings.h"
#include "compare/bounds/triangle_bounds.h"
#include "compare/bounds/view_facts.h"
#include "compare/bounds/z_range.h"
#include "frame/precision.h"

namespace zproof {

/// May near or far cut just above a corner or just below it?
bool is_cut_at_a_corner(const ViewFacts& facts, const TriangleExtent& extent, const TriangleBounds& bounds);

class RasterBounds {
  public:
    RasterBounds(const ViewFacts& facts, const RasterPrecision& precision);

    TriangleBounds of(const ViewFacts& facts, const TriangleExtent& extent) const;
    bool keeps_to_corners() const;
    bool is_homogeneous() const;
    bool clips_at_sides() const { return precision_.clipping == Clipping::view_volume && !is_homogeneous(); }
    bool shows_what_it_compares() const { return precision_.shown_depth == ShownDepth::buffer; }
    /// What turning z into a depth costs, in inverse depth.
    double decoding_error(const ViewFacts& facts) const;
    /// Inverse depths of a z in [0, 1]; everything where the buffer holds no z.
    InverseDepthRange storable(const ViewFacts& facts) const;
    double background_eps_px() const { return background_eps_px_; }
    double snap_px() const { return snap_px_; }
    /// The largest displacement of a corner of the polygon, without the snap.
    double drift_px(const TriangleBounds& bounds, std::span<const WindowCorner> polygon) const;

  private:
    int counted_cuts(const ViewFacts& facts, const TriangleExtent& extent) const;
    double viewport_px(const ViewFacts& facts, const TriangleExtent& extent) const;
    bool narrows_corners() const;
    double narrowing_px(double reach_px) const;
    double transform_error(const ViewFacts& facts, int cuts) const;
    /// The size of what is transformed.
    const glm::dvec3& transformed(const TriangleExtent& extent) const;
    /// What transform and viewport move corners by, and what rounds their depths.
    TriangleBounds of_corners(const ViewFacts& facts, const TriangleExtent& extent, double transform) const;
    double reach_limit_px(const ViewFacts& facts) const;
    /// Replaces the terms of interpolated depth by those of z. `transform` is the matrices' error.
    void set_z(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
               std::span<const WindowCorner> polygon, double transform) const;
    /// The error of z on the triangle, and how far displacement is spread.
    PlaneEquationBounds z_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                 const ViewFacts& facts, const ZRange& z) const;
    /// Adds what rounded edge functions, tolerances and areas do.
    void add_coverage(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                      std::span<const WindowCorner> polygon) const;
    double edge_functions_eps_px(const ViewFacts& facts, const TriangleExtent& extent) const;
    void add_tolerance(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                       double drift_px, const WindowAreas& areas) const;
    /// Adds what weights err by where depth is their mean.
    void add_weights(TriangleBounds& bounds, const ViewFacts& facts, const WindowAreas& areas,
                     std::span<const WindowCorner> polygon) const;
    /// Adds what edge functions and depth err by where nothing is divided before. `transform` as above.
    void add_homogeneous(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                         double transform) const;
    double decoding_error_of_z(const ZRange& z, double z_max) const;
    bool is_wide() const;
    const Gammas& gammas_of_z() const;
    bool has_plain_coverage() const;
    bool has_plain_depth() const;

    RasterPrecision precision_;
    double snap_px_;  ///< how far the grid moves a corner
    double background_eps_px_;
};

}  // namespace zproof
