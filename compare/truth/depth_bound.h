/// Depth where the id is right: the true depth and the interval a faultless renderer may report
/// (docs/bounds.md).
#pragma once

#include <cmath>

#include "compare/truth/neighbourhood.h"
#include "compare/verdict.h"
#include "math/rounding.h"

namespace zproof {

/// The nearness of one triangle over the whole image, in double with a forward error bound. Made once per
/// triangle; the same for every renderer of the view.
struct TriangleNearness {
    /// `first_pixel` is the sight of pixel (0, 0).
    TriangleNearness(const Sight<double>& first_pixel, const Resolution& size, const TriangleExtent& extent,
                     const CornersWorld& p_world);

    bool perspective;
    bool edge_on = false;
    Affine<double> nearness{0, 0, 0};  ///< of pixel indices
    double gradient = 0;               ///< |d/dx| + |d/dy|
    double own_error = 0;              ///< of nearness, anywhere in the image
};

/// The depths that one renderer may report for one triangle.
class TriangleDepth {
  public:
    TriangleDepth(const TriangleNearness& nearness, const TriangleBounds& bounds, bool keeps_to_corners);

    /// The lawful interval at a pixel, in double.
    DepthBound at(int x, int y) const;
    /// Does the interval hold this depth by more than our own rounding? If not, ask is_lawful_depth.
    bool certainly_holds(const DepthBound& bound, float depth) const {
        const double z = depth;
        const double margin = plane_.edge_on       ? 0
                              : plane_.perspective ? 2 * plane_.own_error * z * z
                                                   : plane_.own_error;
        return z >= 0 && bound.low + margin + 8 * unit_roundoff_float64 * z <= z &&
               z <= bound.high - margin - 8 * unit_roundoff_float64 * z;
    }

  private:
    TriangleNearness plane_;
    BoundsOnPlane bounds_;
    double nearest_, farthest_;  ///< camera depths
    bool keeps_to_corners_;
};

/// What renderers of one view share about one triangle.
struct TriangleInView {
    TriangleInView(const View& view, const ViewBounds& any_bounds, const CornersWorld& p_world)
        : TriangleInView(Sight<double>(view, 0, 0), {view.width, view.height}, any_bounds, p_world) {}
    /// `first_pixel` is the sight of pixel (0, 0).
    TriangleInView(const Sight<double>& first_pixel, const Resolution& size, const ViewBounds& any_bounds,
                   const CornersWorld& p_world)
        : extent(any_bounds.extent_of(p_world)), nearness(first_pixel, size, extent, p_world) {}

    TriangleExtent extent;
    TriangleNearness nearness;
};

TriangleDepth depth_of(const TriangleInView& triangle, const ViewBounds& bounds);
/// What both at() and certainly_holds() say, over the whole image; law_of_nothing where that takes more than
/// a law.
DepthLaw depth_law_of(const TriangleInView& triangle, const ViewBounds& bounds);

/// Decides by exact arithmetic where double does not suffice.
bool is_lawful_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                     const PixelPlace& place, float depth);

/// |depth - truth| over the bound on that side; 0 for an exact hit.
inline double error_over_bound(const DepthBound& bound, float depth) {
    const double error = std::abs(depth - bound.truth);
    if (error == 0) return 0;
    const double room = depth < bound.truth ? bound.truth - bound.low : bound.high - bound.truth;
    return std::isinf(room) ? 0 : error / room;
}

}  // namespace zproof
