/// Depth where the id is right: the true depth and the interval a faultless renderer may report
/// (docs/bounds.md).
#pragma once

#include "compare/neighbourhood.h"
#include "compare/verdict.h"

namespace zproof {

/// The nearness of one triangle over the whole image, in double with a forward error bound. Made once per
/// triangle and asked at each of its pixels.
class TriangleDepth {
  public:
    TriangleDepth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world);

    /// The lawful interval at a pixel, in double.
    DepthBound at(int x, int y) const;
    /// Does the interval hold this depth by more than our own rounding? If not, ask is_lawful_depth.
    bool certainly_holds(const DepthBound& bound, float depth) const;

  private:
    void set_nearness(const View& view, const CornersWorld& p_world);

    bool perspective_;
    bool edge_on_ = false;
    bool keeps_to_corners_;
    TriangleBounds bounds_;
    Affine<double> nearness_{0, 0, 0};  ///< of pixel indices
    double gradient_ = 0;
    double own_error_ = 0;  ///< of nearness_, anywhere in the image
};

/// Decides by exact arithmetic where double does not suffice.
bool is_lawful_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world, int x, int y,
                     float depth);

/// |depth - truth| over the bound on that side; 0 for an exact hit.
double error_over_bound(const DepthBound& bound, float depth);

}  // namespace zproof
