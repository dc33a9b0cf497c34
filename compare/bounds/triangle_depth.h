/// The depths that one renderer may report for one triangle, anywhere in the image: the depth rule in double,
/// with a forward error bound (docs/bounds.md). Where that does not settle it, ask is_admissible_depth()
/// (admissible/depth_rule.h).
#pragma once

#include "compare/bounds/bounds.h"
#include "compare/bounds/depth_bound.h"
#include "math/rounding.h"

namespace zproof {

/// What renderers of one view share about one triangle.
struct TriangleInView {
    TriangleInView(const View& view, const ViewBounds& any_bounds, const CornersWorld& p_world)
        : TriangleInView(ViewRay<double>(view, 0, 0), any_bounds, p_world) {}
    /// `first_pixel` is the ray of pixel (0, 0).
    TriangleInView(const ViewRay<double>& first_pixel, const ViewBounds& any_bounds,
                   const CornersWorld& p_world);

    TriangleExtent extent;
    bool is_edge_on = false;
    Affine<double> inverse_depth{0, 0, 0};  ///< of pixel indices
    double gradient = 0;                    ///< |d/dx| + |d/dy|
    double own_error = 0;  ///< of inverse depth, anywhere in the image; infinite where the plane is not known
};

class TriangleDepth {
  public:
    TriangleDepth() = default;
    TriangleDepth(const TriangleInView& triangle, const ViewBounds& bounds);

    /// Has it a plane that is known in double? If not, only its corners bound its depth.
    bool has_plane() const { return has_plane_; }
    Projection projection() const { return projection_; }

    /// The admissible interval at a pixel.
    DepthBound at(int x, int y) const;
    /// Does the interval hold this depth by more than our own rounding?
    bool certainly_holds(const DepthBound& bound, float depth) const {
        if (!(bound.high < unlimited)) return false;
        const bool perspective = projection_ == Projection::perspective;
        const double error = is_edge_on_ ? 0 : own_error_;
        return (perspective ? if_held<Projection::perspective>(bound, depth, error, 0)
                            : if_held<Projection::parallel>(bound, depth, error, 0)) == 0;
    }
    /// Does it lie outside the interval by more than the interval's width and our own rounding? No arithmetic
    /// holds such a depth admissible: the width is more than rounding changes of any term of the bound.
    bool certainly_refuses(const DepthBound& bound, float depth) const {
        if (!has_plane_ || !(bound.high < unlimited)) return false;
        return projection_ == Projection::perspective ? refuses<Projection::perspective>(bound, depth)
                                                      : refuses<Projection::parallel>(bound, depth);
    }
    /// Error / bound at a pixel; -1 where double does not hold the depth admissible for certain. The triangle
    /// must have a plane. Computes without branches, so that the compiler does several pixels at a time.
    template <Projection projection>
    double certain_error(double x, double y, float depth) const {
        const DepthBound bound = rounded(on_plane<projection>(x, y));
        const double error = std::abs(depth - bound.truth), below = bound.truth - bound.low,
                     above = bound.high - bound.truth;
        const double share = error / (depth < bound.truth ? below : above),
                     known = bound.truth < unlimited ? (error > 0 ? share : 0) : -1;
        return if_held<projection>(bound, depth, own_error_, bound.high < unlimited ? known : -1);
    }

  private:
    template <Projection projection>
    static double depth_of(double inverse_depth) {
        if constexpr (projection == Projection::parallel) return -inverse_depth;
        const double reciprocal = 1 / inverse_depth;
        return inverse_depth > 0 ? reciprocal : unlimited;
    }
    /// Depths before rounding, and the bounds of that.
    struct UnroundedDepth {
        double low, truth, high;
        LocalBounds local;
    };
    static DepthBound rounded(const UnroundedDepth& range) {
        const double r = range.local.depth_relative, a = range.local.depth_absolute;
        const bool is_bounded = r + a + range.local.inverse_depth_error < unlimited;
        const double low = range.low - std::abs(range.low) * r - a,
                     high = range.high + std::abs(range.high) * r + a;
        // beyond the plane's horizon no depth is near enough
        const double low_or_none = std::isinf(range.low) ? range.low : low;
        return {is_bounded ? low_or_none : 0, range.truth, is_bounded ? high : unlimited};
    }
    template <Projection projection>
    UnroundedDepth on_plane(double x, double y) const {
        const double inverse_depth = inverse_depth_.at(x, y);
        const LocalBounds local = bounds_.at(inverse_depth);
        const double shift = local.depth_eps_px * gradient_ + local.inverse_depth_error,
                     middle = inverse_depth + local.inverse_depth_bias;
        const double low = held_between(depth_of<projection>(middle + shift), least_depth_, greatest_depth_),
                     high = held_between(depth_of<projection>(middle - shift), least_depth_, greatest_depth_);
        return {low, held_between(depth_of<projection>(inverse_depth), low, high), high, local};
    }
    /// What a limit near the depth h >= 0 may be off by, with our own rounding. An error g of inverse depth
    /// is one of g h / (1 - g h) in the depth h: at most 2 g h^2, or the depth is not held.
    template <Projection projection>
    static double unsure_of(double h, double own_error) {
        constexpr double rounding = 8 * unit_roundoff_float64;
        return (projection == Projection::perspective ? 2 * own_error * h * h : own_error) + rounding * h;
    }
    /// The value, or -1 where the bound does not hold z for certain. Conditions stand one by one: the
    /// compiler does several pixels at a time of choices between numbers, not of logic.
    template <Projection projection>
    static double if_held(const DepthBound& bound, double z, double own_error, double value) {
        const double least = bound.low + unsure_of<projection>(z, own_error),
                     greatest = bound.high - unsure_of<projection>(bound.high, own_error);
        const double if_before_eye = z >= 0 ? value : -1, if_above = least <= z ? if_before_eye : -1;
        return z <= greatest ? if_above : -1;
    }
    template <Projection projection>
    bool refuses(const DepthBound& bound, double z) const {
        const double unsure =
            bound.high - bound.low + unsure_of<projection>(std::abs(bound.high), own_error_);
        const bool is_known = projection == Projection::parallel || own_error_ * bound.high <= 0.5;
        return is_known && z >= 0 && z < unlimited && (z < bound.low - unsure || z > bound.high + unsure);
    }

    Affine<double> inverse_depth_{0, 0, 0};
    double gradient_ = 0, own_error_ = 0;
    BoundsOnPlane bounds_;
    double nearest_ = 0, farthest_ = 0;            ///< camera depths of the corners
    double least_depth_ = 0, greatest_depth_ = 0;  ///< the same, where the renderer keeps to them
    Projection projection_ = Projection::perspective;
    bool has_plane_ = false, is_edge_on_ = true;
};

}  // namespace zproof
