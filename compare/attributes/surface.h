/// A triangle around a pixel, as values are interpolated over it.
#pragma once

#include <optional>

#include "compare/admissible/neighbourhood.h"
#include "compare/bounds/view_facts.h"

namespace zproof {

struct Surface {
    const ViewFacts& facts;
    PixelCoord pixel;
    ViewRay<double> ray;
    TriangleExtent extent;
    TriangleBounds bounds;  ///< of a depth that is interpolated like other values
    Neighbour seen;         ///< with an image

    double least_sum = 0;            ///< of the weights, anywhere in the square of depth_eps_px; above 0
    double spread = 1;               ///< the largest sum of |weights| there over that
    double least_inverse_depth = 0;  ///< of the plane there

    const CornersWorld& p_world() const { return seen.p_world; }
};

/// Measures the weights; nothing where double does not know their sum to be above 0.
std::optional<Surface> surface_at(const ViewFacts& facts, const ViewBounds& bounds,
                                  const CornersWorld& p_world, const PixelCoord& pixel);

}  // namespace zproof
