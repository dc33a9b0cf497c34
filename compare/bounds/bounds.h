/// Turns declared precision into bounds for the triangles of one view (docs/bounds.md).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compare/bounds/bounded_bounds.h"
#include "compare/bounds/depth_bound.h"
#include "compare/bounds/plane_ray_bounds.h"
#include "compare/bounds/raster_bounds.h"
#include "compare/bounds/ray_bounds.h"
#include "frame/precision.h"

namespace zproof {

/// Does the renderer promise to leave no gap between triangles that share an edge?
bool is_watertight(const Precision& precision);

/// Why the promise says nothing of the view: depth_of_range without a finite far. Empty: it does.
std::string unjudgeable(const Camera& camera, const Precision& precision);

/// What a renderer's precision means for one view.
class ViewBounds {
  public:
    /// The bounds of the depths that are compared. Throws FrameError where it is unjudgeable().
    ViewBounds(const View& view, const Precision& precision);
    /// The bounds of the depths that a frame shows: of another kind, or stored in steps.
    static ViewBounds of_shown(const View& view, const Precision& precision);

    TriangleExtent extent_of(const CornersWorld& p_world) const { return facts_.extent_of(p_world); }
    TriangleBounds of(const TriangleExtent& extent) const;
    TriangleBounds of(const CornersWorld& p_world) const { return of(extent_of(p_world)); }
    /// Is every depth a weighted mean of the corners'? A ray and a plane equation meet the plane beyond them.
    bool keeps_to_corners() const { return raster() && raster()->keeps_to_corners(); }
    /// What inverse depth may have been compared where this depth is shown; what decoding z costs included.
    /// Everything where another depth is compared than is shown.
    InverseDepthRange compared_at(double depth) const;
    /// How far a reported depth may lie from the one that was rounded to its step; 0 without steps.
    double step_room(double depth) const {
        return depth_step_ > 0 ? depth_step_ / 2 + 2 * unit_roundoff_float32 * std::abs(depth) : 0;
    }
    /// Can a depth buffer hold that? It holds z in [0, 1].
    bool can_be_stored(double depth) const;
    /// Do triangles that share an edge move it alike?
    bool is_watertight() const { return is_watertight_; }
    /// It may clip a triangle by near, far and the sides of one of these, and make several of what is left.
    /// None of a ray caster and of a homogeneous rasterizer.
    const std::vector<Window>& clip_windows() const { return clip_windows_; }
    /// Is every pixel's depth held against near and far?
    bool cuts_by_depth() const { return !raster() || raster()->is_homogeneous(); }
    /// Does clipping put new edges on the image's sides?
    bool clips_at_sides() const { return raster() && raster()->clips_at_sides(); }
    Projection projection() const { return facts_.view.camera.projection; }
    /// The camera depth before which nothing is drawn.
    double near_depth() const { return near_depth_; }
    /// Sums of the terms that the image's rays are made of, each in absolute value, at their largest.
    struct RaySize {
        double origin, direction;
    };
    RaySize ray_size() const {
        const glm::dvec3 eye(facts_.view.camera.eye_world);
        return {sum_abs(abs(eye) + facts_.origin_abs), sum_abs(facts_.direction_abs)};
    }
    /// No |inverse depth| in the image is larger; `inverse_depth` is of pixel indices.
    double largest_in_image(const Affine<double>& inverse_depth) const {
        return std::abs(inverse_depth.c) + std::abs(inverse_depth.a) * facts_.view.width +
               std::abs(inverse_depth.b) * facts_.view.height;
    }
    /// The share that every triangle has in common; above 0.
    double background_eps_px() const;
    /// No triangle's eps is less; may be 0.
    double least_eps_px() const { return raster() ? raster()->snap_px() : background_eps_px(); }

  private:
    using OfKind = std::variant<RasterBounds, RayBounds, PlaneRayBounds, BoundedBounds>;

    ViewFacts facts_;
    double near_depth_;
    double depth_step_;         ///< between reported depths, scene units
    bool is_of_shown_ = false;  ///< does a depth's bound hold what is rounded to a step?
    bool is_watertight_;
    std::vector<Window> clip_windows_;
    OfKind of_kind_;
    std::optional<RasterBounds>
        clipping_{};  ///< of a shown varying: what is compared, and cut by near and far

    const RasterBounds* raster() const { return std::get_if<RasterBounds>(&of_kind_); }
    InverseDepthRange compared_before_steps(double depth) const;
};

}  // namespace zproof
