/// How far a faultless renderer may displace one triangle in the image, and how far its depth may be off.
/// Every term is derived in docs/bounds.md under the name it has here.
#pragma once

#include <algorithm>
#include <array>

#include "compare/bounds/depth_bound.h"

namespace zproof {

/// The bounds of one triangle at one place of the image.
struct LocalBounds {
    double eps_px = 0;          ///< coverage: displacement in x and in y
    double depth_eps_px = 0;    ///< displacement at which depth may have been taken
    double depth_relative = 0;  ///< delta: relative error of depth; infinite where the plane is not known
    double depth_absolute = 0;  ///< alpha: absolute error of depth, scene units
    double inverse_depth_error = 0;  ///< of inverse depth itself; unlimited where the plane is not known
    double inverse_depth_bias = 0;   ///< how far from the truth that error is centred: z that is cut off
};

/// The bounds of one triangle that are the same wherever it is seen.
struct TriangleLimits {
    double near_slack = 0, far_slack = 0;  ///< clip: the planes' places may be off by this depth, scene units
    double nearest = 0, farthest = 0;      ///< camera depths of the corners, clamped to near and far
    bool may_be_missing = false;           ///< the renderer need not draw it: it hides nothing for certain
    /// The share of eps by which each edge function is off where it is rounded by itself, px; else 0.
    std::array<double, 3> edge_rounding_px{};
    double weight_tolerance = 0;     ///< a weight down to minus this counts as inside
    bool has_image_weights = false;  ///< perspectives: edge functions times their corners' depths are weights

    /// May the near or far plane cut it?
    bool may_be_clipped(const Camera& camera) const {
        return nearest <= camera.near_depth + near_slack || farthest >= camera.far_depth - far_slack;
    }
    /// May it be shown where no displacement brings it?
    bool may_be_shown_by_rounding() const {
        return std::ranges::max(edge_rounding_px) > 0 || weight_tolerance > 0;
    }
};

/// The bounds of one triangle, as functions of its inverse depth (1/depth; perspective) at the pixel.
struct TriangleBounds : TriangleLimits {
    double nearest_shown = 0;  ///< `nearest`, or less: what lies before near within its slack may be shown
    double eps_base_px = 0, eps_per_inverse_depth = 0;  ///< eps = base + per_inverse_depth * inverse depth
    double depth_eps_base_px = 0, depth_eps_per_inverse_depth = 0;  ///< the same for depth
    double depth_factor = 0;  ///< sum of the relative errors of depth's factors
    double depth_share = 0;   ///< a further relative error of depth, as a share of itself
    double depth_absolute = 0;
    double inverse_depth_error = 0;  ///< z-buffer: of inverse depth, anywhere on the triangle
    double inverse_depth_bias = 0;   ///< z-buffer: what z that is cut off adds on average
    double plane_offset = 0;         ///< ray: error of (normal . direction) / volume, in inverse depth

    /// Displaces the place of depth as far as coverage.
    void displace_depth_alike() {
        depth_eps_base_px = eps_base_px;
        depth_eps_per_inverse_depth = eps_per_inverse_depth;
    }
    /// The largest eps anywhere on the triangle: at its nearest corner.
    double most_eps_px() const {
        const double highest = nearest_shown > 0 ? 1 / nearest_shown : 0;
        return eps_base_px + (eps_per_inverse_depth > 0 ? eps_per_inverse_depth * highest : 0);
    }
};

/// 1 / (1 - sum) - 1: what factors and divisors whose relative errors add up to `sum` may come to (Higham
/// 2002, Lemma 3.1); unlimited from 1 up.
inline double compounded(double sum) {
    const double share = sum / (1 - sum);
    return sum < 1 ? share : unlimited;
}

/// `a` held between two limits.
inline double held_between(double a, double low, double high) {
    const double raised = a < low ? low : a;
    return high < raised ? high : raised;
}

/// eps = base + per (inverse depth + gradient eps), solved for eps; never beyond the nearest corner's.
struct Displacement {
    Displacement() = default;
    Displacement(double base_px, double per_inverse_depth, double gradient, double highest)
        : base(base_px), per(per_inverse_depth), most(base + per * highest) {
        const double loop = per * gradient, enlarged = 1 / (1 - loop);
        amplification = loop < 1 ? enlarged : unlimited;
    }

    double at(double inverse_depth) const {
        const double reach = (base + per * inverse_depth) * amplification, kept = reach < most ? reach : most;
        return per == 0 ? base : kept;
    }

    double base = 0, per = 0, most = 0, amplification = 1;
};

/// The inverse depth of the farthest and the nearest corner.
struct CornerInverseDepth {
    CornerInverseDepth() = default;
    CornerInverseDepth(double nearest_depth, double farthest_depth) {
        const double of_farthest = 1 / farthest_depth, of_nearest = 1 / nearest_depth;
        least = farthest_depth > 0 ? of_farthest : 0;  // 0 at infinity, too
        highest = nearest_depth > 0 ? of_nearest : 0;
    }

    double least = 0, highest = 0;
};

/// The local bounds at many places of one triangle, on which inverse depth changes by `gradient` (|d/dx| +
/// |d/dy|) per pixel. Without branches, so that the compiler works on several pixels at a time.
class BoundsOnPlane {
  public:
    BoundsOnPlane() = default;
    BoundsOnPlane(const TriangleBounds& b, double gradient)
        : corners_(b.nearest_shown, b.farthest),
          eps_px_(b.eps_base_px, b.eps_per_inverse_depth, gradient, corners_.highest),
          depth_eps_px_(b.depth_eps_base_px, b.depth_eps_per_inverse_depth, gradient, corners_.highest),
          depth_factor_(b.depth_factor),
          depth_share_(b.depth_share),
          plane_offset_(b.plane_offset),
          depth_absolute_(b.depth_absolute),
          inverse_depth_error_(b.inverse_depth_error),
          inverse_depth_bias_(b.inverse_depth_bias) {}

    LocalBounds at(double inverse_depth) const {
        const double here = held_between(inverse_depth, corners_.least, corners_.highest);
        const double offset = plane_offset_ / here;
        return {.eps_px = eps_px_.at(here),
                .depth_eps_px = depth_eps_px_.at(here),
                .depth_relative = compounded(depth_factor_ + (plane_offset_ > 0 ? offset : 0)) + depth_share_,
                .depth_absolute = depth_absolute_,
                .inverse_depth_error = inverse_depth_error_,
                .inverse_depth_bias = inverse_depth_bias_};
    }

  private:
    CornerInverseDepth corners_;
    Displacement eps_px_, depth_eps_px_;
    double depth_factor_ = 0, depth_share_ = 0, plane_offset_ = 0;
    double depth_absolute_ = 0, inverse_depth_error_ = 0,
           inverse_depth_bias_ = 0;  ///< the same at all places
};

}  // namespace zproof
