/// A triangle around a pixel, as values are interpolated over it.
#pragma once

#include "compare/admissible/neighbourhood.h"
#include "compare/bounds/view_facts.h"

namespace zproof {

struct Surface {
    const ViewFacts& facts;
    PixelCoord pixel;
    ViewRay<double> ray;
    TriangleExtent extent;
    TriangleBounds bounds;  ///< of a depth that is interpolated like other values
    Neighbour seen;

    /// The weights' sum is at least this: at the centre, and anywhere in the square of depth_eps_px. Not
    /// above 0 where double does not know the triangle's plane or that the sum is above 0.
    double sum_at_centre = 0, least_sum = 0;
    double spread_at_centre = unlimited;  ///< sum of |weights| over their sum
    double least_inverse_depth = 0;       ///< of the plane in the square

    const CornersWorld& p_world() const { return seen.p_world; }
    /// Is the triangle's plane known, and does it not hold the view ray?
    bool has_plane() const { return seen.image && seen.is_plane_known; }
    bool has_centre() const { return sum_at_centre > 0; }
};

Surface surface_at(const ViewFacts& facts, const ViewBounds& bounds, const CornersWorld& p_world,
                   const PixelCoord& pixel);

}  // namespace zproof
