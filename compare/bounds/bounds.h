/// Turns declared precision into bounds: how far a faultless renderer may displace a triangle in the image,
/// and how far its depth may be off. Every term is derived in docs/bounds.md under the name it has here.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "compare/bounds/depth_terms.h"
#include "compare/bounds/triangle_extent.h"
#include "frame/precision.h"
#include "scenes/view.h"

namespace zproof {

/// The bounds of one triangle at one place of the image.
struct LocalBounds {
    double eps_px = 0;          ///< coverage: displacement in x and in y
    double depth_eps_px = 0;    ///< displacement at which depth may have been taken
    double depth_relative = 0;  ///< delta: relative error of depth; infinite where the plane is not known
    double depth_absolute = 0;  ///< alpha: absolute error of depth, scene units
    double inverse_depth_error = 0;  ///< of inverse depth itself; unlimited where the plane is not known
};

/// The terms of every triangle's depth, where a renderer has such.
using CommonTerms = std::variant<std::monostate, RasterTerms, RayTerms>;

/// The bounds of one triangle, as functions of its inverse depth (1/depth; perspective) at the pixel.
struct TriangleBounds {
    double eps_base_px = 0, eps_per_inverse_depth = 0;  ///< eps = base + per_inverse_depth * inverse depth
    double depth_eps_base_px = 0, depth_eps_per_inverse_depth = 0;  ///< the same for depth
    double depth_factor = 0;  ///< sum of the relative errors of depth's factors
    double depth_absolute = 0;
    double inverse_depth_error = 0;        ///< z-buffer: of inverse depth, anywhere on the triangle
    double plane_offset = 0;               ///< ray: error of (normal . direction) / volume, in inverse depth
    double near_slack = 0, far_slack = 0;  ///< clip: the planes' places may be off by this depth, scene units
    double nearest = 0, farthest = 0;      ///< camera depths of the corners, clamped to near and far

    /// The bounds at a place where inverse depth is `inverse_depth` and changes by `gradient` (|d/dx| +
    /// |d/dy|) per pixel.
    LocalBounds at(double inverse_depth, double gradient) const;
    DepthTerms depth_terms() const {
        return {depth_eps_base_px, depth_eps_per_inverse_depth, depth_factor,
                depth_absolute,    inverse_depth_error,         plane_offset};
    }
};

/// The local bounds at many places of one triangle: what does not change from pixel to pixel is worked out
/// once.
class BoundsOnPlane {
  public:
    BoundsOnPlane(const TriangleBounds& bounds, double gradient);

    LocalBounds at(double inverse_depth) const {
        const double here = std::clamp(inverse_depth, corners_.least, corners_.highest);
        return {.eps_px = eps_px_.at(here),
                .depth_eps_px = depth_eps_px_.at(here),
                .depth_relative =
                    plane_offset_ > 0 ? compounded(depth_factor_ + plane_offset_ / here) : depth_relative_,
                .depth_absolute = depth_absolute_,
                .inverse_depth_error = inverse_depth_error_};
    }

  private:
    CornerInverseDepth corners_;
    Displacement eps_px_, depth_eps_px_;
    double depth_factor_, plane_offset_, depth_relative_, depth_absolute_, inverse_depth_error_;
};

/// What a renderer's precision means for one view.
class ViewBounds {
  public:
    ViewBounds(const View& view, const Precision& precision);

    TriangleExtent extent_of(const CornersWorld& p_world) const;
    TriangleBounds of(const TriangleExtent& extent) const;
    TriangleBounds of(const CornersWorld& p_world) const { return of(extent_of(p_world)); }
    /// What depth needs of it.
    DepthTerms depth_terms(const TriangleExtent& extent) const;
    /// Camera depths of the corners, clamped to near and far.
    struct CornerDepths {
        double nearest, farthest;
    };
    CornerDepths corner_depths(const TriangleExtent& extent) const;
    /// Barycentrics of a snapped triangle stay between its corners' depths; a ray and a plane equation meet
    /// the plane.
    bool keeps_to_corners() const;
    Projection projection() const { return view_.camera.projection; }
    /// Sums of the terms that the image's rays are made of, each in absolute value, at their largest.
    struct RaySize {
        double origin, direction;
    };
    RaySize ray_size() const {
        const Vector3<double> origin = gauge_.eye_abs + gauge_.origin_abs, &direction = gauge_.direction_abs;
        return {origin.x + origin.y + origin.z, direction.x + direction.y + direction.z};
    }
    /// No |inverse depth| in the image is larger; `inverse_depth` is of pixel indices.
    double largest_in_image(const Affine<double>& inverse_depth) const {
        return std::abs(inverse_depth.c) + std::abs(inverse_depth.a) * view_.width +
               std::abs(inverse_depth.b) * view_.height;
    }
    /// The share that every triangle has in common; above 0.
    double background_eps_px() const { return background_eps_px_; }

  private:
    TriangleBounds bounds_by(const TriangleExtent& extent, const RasterPrecision& precision) const;
    /// Replaces the terms of interpolated depth by those of a reversed z from a plane equation.
    void set_reversed_z(TriangleBounds& bounds, const TriangleExtent& extent) const;
    TriangleBounds bounds_by(const TriangleExtent& extent, const RayPrecision& precision) const;
    double transform_error(const RasterPrecision& precision, int cuts) const;
    RasterTerms raster_terms(const RasterPrecision& precision, double transform, double viewport) const;
    RayTerms ray_terms(const RayPrecision& precision) const;
    static double framing_by(const RayPrecision& precision);
    CommonTerms common_terms() const;
    TriangleBounds bounds_by(const TriangleExtent& extent, const PlaneRayPrecision& precision) const;
    /// How far a point that a ray met may seem to lie from where it is on its triangle, scene units.
    double plane_test_error(const TriangleExtent& extent, const PlaneRayPrecision& precision) const;
    /// The largest sum of coordinates of a point or origin that the arithmetic of a ray caster meets.
    double ray_reach(const TriangleExtent& extent) const;
    double lateral_px(const glm::dvec3& camera_abs) const;
    /// The farthest that a corner lies from the image's origin or the window's centre, px; `limit` where near
    /// may cut the triangle or clipping keeps corners nearer.
    double reach_px(const TriangleExtent& extent, double limit) const;
    /// The reach of corners that clipping put on the window's sides, px.
    double window_reach_px() const;
    /// Planes of the view volume with a corner of the triangle beyond.
    int cut_count(const TriangleExtent& extent) const;
    double edge_test_eps_px(const TriangleExtent& extent, int edge, double unit) const;
    void set_aim(double unit, double offset_px = 0);
    Gauge make_gauge() const;

    View view_;
    Precision precision_;
    bool perspective_;
    ImageScale scale_;
    double largest_u_, largest_v_;  ///< of |window|
    glm::dvec3 direction_abs_;      ///< per world axis, the largest |direction| in the image
    glm::dvec3 origin_abs_;         ///< per world axis, the largest |origin - eye|
    double orthonormality_;         ///< largest entry of |R R^T - I|
    double background_eps_px_ = 0;
    /// A ray's own rounding: sideways, px (and px per unit of depth), and along the view axis.
    double aim_px_ = 0, aim_px_per_depth_ = 0, aim_depth_relative_ = 0, aim_depth_absolute_ = 0;
    Gauge gauge_;
    CommonTerms common_terms_;
};

}  // namespace zproof
