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
    DepthBound at(int x, int y) const { return rounded(range_at(x, y)); }
    /// Does the interval hold this depth by more than our own rounding?
    bool certainly_holds(const DepthBound& bound, float depth) const {
        if (!(bound.high < unlimited)) return false;
        const bool perspective = projection_ == Projection::perspective;
        const double error = is_edge_on_ ? 0 : own_error_;
        return perspective ? holds<Projection::perspective>(bound, depth, error)
                           : holds<Projection::parallel>(bound, depth, error);
    }

    /// Is the relative error of depth the same all over the triangle?
    enum class Relative { constant, by_inverse_depth };
    Relative relative() const { return plane_offset_ > 0 ? Relative::by_inverse_depth : Relative::constant; }
    struct CertainError {
        double over_bound;  ///< error / bound; -1 where double does not hold the depth admissible for certain
        double room;        ///< depths that differ from this one by no more are certainly admissible, too
    };
    /// The triangle must have a plane. Computes without branches.
    template <Projection projection, Relative relative>
    CertainError certain_error(double x, double y, float depth) const {
        const UnroundedDepth range = on_plane<projection, relative>(x, y);
        const DepthBound bound{widened_low(range), range.truth, widened_high(range)};
        const bool is_certain = is_bounded(range.relative + absolute_ + inverse_depth_error_) &
                                (range.relative >= 0) & (range.truth < unlimited) &
                                holds<projection>(bound, depth, own_error_);
        const double error = std::abs(depth - bound.truth), below = bound.truth - bound.low,
                     above = bound.high - bound.truth;
        const double share = error / (depth < bound.truth ? below : above);
        const double most = bound.high < unlimited ? bound.high : 0;
        const double width = (below < above ? below : above) - 2 * unsure_of<projection>(most, own_error_),
                     room = width - error;  // nor is a depth below 0 ever certain
        return {is_certain ? (error > 0 ? share : 0) : -1,
                is_certain ? (room < depth ? room : double(depth)) : -1};
    }

  private:
    template <Projection projection>
    static double depth_of(double inverse_depth) {
        if constexpr (projection == Projection::parallel) return -inverse_depth;
        const double reciprocal = 1 / inverse_depth;
        return inverse_depth > 0 ? reciprocal : unlimited;
    }
    static double held_between(double a, double low, double high) {
        const double raised = a < low ? low : a;
        return high < raised ? high : raised;
    }
    /// compounded(), but where that is unlimited: there it is none that is_bounded() takes, so that no branch
    /// is needed.
    template <Relative relative>
    double relative_at(double inverse_depth) const {
        if constexpr (relative == Relative::constant) return relative_;
        const double sum = factor_ + plane_offset_ / inverse_depth;
        return sum / (1 - sum);
    }
    static bool is_bounded(double relative) { return (relative >= 0) & (relative < unlimited); }
    /// Depths before rounding, and its relative error.
    struct UnroundedDepth {
        double low, truth, high, relative;
    };
    double widened_low(const UnroundedDepth& range) const {
        return range.low - std::abs(range.low) * range.relative - absolute_;
    }
    double widened_high(const UnroundedDepth& range) const {
        return range.high + std::abs(range.high) * range.relative + absolute_;
    }
    DepthBound rounded(const UnroundedDepth& range) const {
        const bool is_bounded_here =
            is_bounded(range.relative) && absolute_ + inverse_depth_error_ < unlimited;
        if (!is_bounded_here) return {0, range.truth, unlimited};
        // beyond the plane's horizon no depth is near enough
        return {std::isinf(range.low) ? range.low : widened_low(range), range.truth, widened_high(range)};
    }
    template <Projection projection, Relative relative>
    UnroundedDepth on_plane(double x, double y) const {
        const double inverse_depth = inverse_depth_.at(x, y),
                     here = held_between(inverse_depth, corners_.least, corners_.highest);
        const double shift = eps_px_.at(here) * gradient_ + inverse_depth_error_;
        const double middle = inverse_depth + inverse_depth_bias_;
        const double low = held_between(depth_of<projection>(middle + shift), least_depth_, greatest_depth_),
                     high = held_between(depth_of<projection>(middle - shift), least_depth_, greatest_depth_);
        return {low, held_between(depth_of<projection>(inverse_depth), low, high), high,
                relative_at<relative>(here)};
    }
    UnroundedDepth range_at(double x, double y) const;
    /// What a limit near the depth h >= 0 may be off by, with our own rounding. An error g of inverse depth
    /// is one of g h / (1 - g h) in the depth h: at most 2 g h^2, or the depth is not held.
    template <Projection projection>
    static double unsure_of(double h, double own_error) {
        constexpr double rounding = 8 * unit_roundoff_float64;
        return (projection == Projection::perspective ? 2 * own_error * h * h : own_error) + rounding * h;
    }
    template <Projection projection>
    static bool holds(const DepthBound& bound, float depth, double own_error) {
        const double z = depth;
        return (z >= 0) & (bound.low + unsure_of<projection>(z, own_error) <= z) &
               (z <= bound.high - unsure_of<projection>(bound.high, own_error));
    }

    Affine<double> inverse_depth_{0, 0, 0};
    double gradient_ = 0, own_error_ = 0;
    CornerInverseDepth corners_;
    Displacement eps_px_;
    double factor_ = 0, plane_offset_ = 0, relative_ = 0, absolute_ = 0, inverse_depth_error_ = 0,
           inverse_depth_bias_ = 0;
    double nearest_ = 0, farthest_ = 0;            ///< camera depths of the corners
    double least_depth_ = 0, greatest_depth_ = 0;  ///< the same, where the renderer keeps to them
    Projection projection_ = Projection::perspective;
    bool has_plane_ = false, is_edge_on_ = true;
};

}  // namespace zproof
