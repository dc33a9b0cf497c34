/// From declared precision to bounds: how far a faultless renderer may displace a triangle in the image, and
/// how far its depth may be off. Every term is derived in docs/bounds.md under the name it has here.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "compare/depth_law.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// A bound where nothing is known.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

using CornersWorld = std::array<glm::vec3, 3>;

/// The bounds of one triangle at one place of the image.
struct LocalBounds {
    double eps_px = 0;          ///< coverage: displacement in x and in y
    double depth_eps_px = 0;    ///< displacement at which depth may have been taken
    double depth_relative = 0;  ///< delta: relative error of depth; infinite where the plane is not known
    double depth_absolute = 0;  ///< alpha: absolute error of depth, scene units
    double nearness_error = 0;  ///< of nearness itself; unlimited where the plane is not known
};

/// Sums of absolute products behind nearness = (normal . direction) / volume: how ill-conditioned it is.
/// Parallel projections: depth = (normal . corner) / facing, in the same places.
struct PlaneSize {
    double volume = 0, volume_abs = 0, numerator_abs = 0;
    /// Parallel projections: what the judge's own rounding of the origin of sight may add to the numerator.
    double origin_error = 0;
};

/// Forward error of the judge's own nearness, computed in double by image_of: absolute sums of both products,
/// 16 roundings at most in each.
class PlaneError {
  public:
    PlaneError() = default;
    explicit PlaneError(const PlaneSize& size);

    /// Is the plane's orientation, as seen, certain?
    bool is_known() const { return is_known_; }
    /// Where |nearness| is at most this.
    double at(double largest_nearness) const { return is_known_ ? known_at(largest_nearness) : unlimited; }
    /// The same where the orientation is known.
    double known_at(double largest_nearness) const {
        return 2 * rounding_ * (numerator_ + largest_nearness * condition_) + of_origin_;
    }

  private:
    bool is_known_ = false;
    double rounding_ = 0, condition_ = 0, numerator_ = 0, of_origin_ = 0;
};

/// A triangle's size as the error analysis sees it, the same for every renderer of a view: sums of absolute
/// products per camera axis.
struct TriangleExtent {
    std::array<glm::dvec3, 3> v_world;  ///< corner - eye
    std::array<double, 3> depth;
    glm::dvec3 from_eye{0};     ///< max over corners of sum |axis_j| |p_j - eye_j|
    glm::dvec3 from_origin{0};  ///< max over corners of sum |axis_j| (|p_j| + |eye_j|)
    PlaneSize plane_size;

    double largest_depth() const;  ///< of the corners, in absolute value
};

/// The bounds of one triangle, as functions of its nearness (1/depth; perspective) at the pixel.
struct TriangleBounds {
    double eps_base_px = 0, eps_per_nearness = 0;              ///< eps = base + per_nearness * nearness
    double depth_eps_base_px = 0, depth_eps_per_nearness = 0;  ///< the same for depth
    double depth_factor = 0;  ///< sum of the relative errors of depth's factors
    double depth_absolute = 0;
    double nearness_error = 0;             ///< z-buffer: of nearness, anywhere on the triangle
    double plane_offset = 0;               ///< ray: error of (normal . direction) / volume, in nearness
    double near_slack = 0, far_slack = 0;  ///< clip: the planes' places may be off by this depth, scene units
    double nearest = 0, farthest = 0;      ///< camera depths of the corners, clamped to near and far

    /// At a place where nearness is `nearness` and changes by `gradient` (|d/dx| + |d/dy|) per pixel.
    LocalBounds at(double nearness, double gradient) const;
};

/// The same for many places of one triangle: what does not change from pixel to pixel is worked out once.
class BoundsOnPlane {
  public:
    BoundsOnPlane(const TriangleBounds& bounds, double gradient);

    LocalBounds at(double nearness) const {
        const double here = std::clamp(nearness, least_, highest_);
        return {.eps_px = eps_px_.at(here),
                .depth_eps_px = depth_eps_px_.at(here),
                .depth_relative =
                    plane_offset_ > 0 ? compounded(depth_factor_ + plane_offset_ / here) : depth_relative_,
                .depth_absolute = depth_absolute_,
                .nearness_error = nearness_error_};
    }

    /// What compare/depth_law.h needs of it; the rest of the law is left for the caller.
    DepthLaw depth_law() const;

    /// What factors and divisors whose relative errors add up to `sum` may come to: 1 / (1 - sum) - 1 (Higham
    /// 2002, Lemma 3.1); unlimited from 1 up.
    static double compounded(double sum) { return sum < 1 ? sum / (1 - sum) : unlimited; }

  private:
    /// eps = base + per (nearness + gradient eps), solved for eps; never beyond the nearest corner's.
    struct Displacement {
        double base, per, most, amplification;
        double at(double nearness) const {
            return per == 0 ? base : std::min(most, (base + per * nearness) * amplification);
        }
    };
    Displacement displacement(double base, double per, double gradient) const;

    double least_, highest_;  ///< nearness of the farthest and the nearest corner
    Displacement eps_px_, depth_eps_px_;
    double depth_factor_, plane_offset_, depth_relative_, depth_absolute_, nearness_error_;
};

/// What a renderer's precision means for one view.
class ViewBounds {
  public:
    ViewBounds(const View& view, const Precision& precision);

    TriangleExtent extent_of(const CornersWorld& p_world) const;
    TriangleBounds of(const TriangleExtent& extent) const;
    TriangleBounds of(const CornersWorld& p_world) const { return of(extent_of(p_world)); }
    /// What depth needs of it; eps and slack may be missing.
    TriangleBounds of_depth(const TriangleExtent& extent) const;
    /// Barycentrics of a snapped triangle stay between its corners' depths; a ray and a plane equation meet
    /// the plane.
    bool keeps_to_corners() const;
    /// The share that every triangle has in common; above 0.
    double background_eps_px() const { return background_eps_px_; }

  private:
    PlaneSize plane_size_of(const TriangleExtent& extent, const CornersWorld& p_world) const;
    TriangleBounds bounds_by(const TriangleExtent& extent, const RasterPrecision& precision) const;
    /// Replaces the terms of interpolated depth by those of a reversed z from a plane equation.
    void set_reversed_z(TriangleBounds& bounds, const TriangleExtent& extent) const;
    TriangleBounds bounds_by(const TriangleExtent& extent, const RayPrecision& precision) const;
    TriangleBounds hit_depth_by(const TriangleExtent& extent, const RayPrecision& precision) const;
    static double framing_by(const RayPrecision& precision);
    TriangleBounds between_the_planes(TriangleBounds bounds, const TriangleExtent& extent) const;
    TriangleBounds bounds_by(const TriangleExtent& extent, const PlaneRayPrecision& precision) const;
    /// How far a point that a ray met may seem to lie from where it is on its triangle, scene units.
    double plane_test_error(const TriangleExtent& extent, const PlaneRayPrecision& precision) const;
    /// The largest sum of coordinates of a point or origin that the arithmetic of a ray caster meets.
    double ray_reach(const TriangleExtent& extent) const;
    /// Largest displacement in the image, px times depth, of errors of camera_abs along the camera's axes.
    double lateral_px(const glm::dvec3& camera_abs) const;
    /// The farthest that a corner lies from the image's origin or the window's centre, px; `limit` where near
    /// may cut the triangle or clipping keeps corners nearer.
    double reach_px(const TriangleExtent& extent, double limit) const;
    /// The same for corners that clipping put on the window's sides.
    double window_reach_px() const;
    /// Planes of the view volume with a corner of the triangle beyond.
    int cut_count(const TriangleExtent& extent) const;
    double edge_test_eps_px(const TriangleExtent& extent, int edge, double unit) const;
    void set_aim(double unit, double offset_px = 0);

    View view_;
    Precision precision_;
    bool perspective_;
    double px_per_u_, px_per_v_;    ///< pixels per unit of the image plane
    double largest_u_, largest_v_;  ///< of |window|
    double slant_u_, slant_v_;      ///< largest |d(u, v)/d depth| of a line of sight in the image
    glm::dvec3 direction_abs_;      ///< per world axis, the largest |direction| in the image
    glm::dvec3 origin_abs_;         ///< per world axis, the largest |origin - eye|
    double orthonormality_;         ///< largest entry of |R R^T - I|
    double background_eps_px_ = 0;
    /// A ray's own rounding: sideways, px (and px per unit of depth), and along the view axis.
    double aim_px_ = 0, aim_px_per_depth_ = 0, aim_depth_relative_ = 0, aim_depth_absolute_ = 0;
};

}  // namespace zproof
