/// The integral of a surface's albedo over a convex piece of the image.
#pragma once

#include "oracle/area/polygon.h"
#include "oracle/area/surfaces.h"

namespace zproof::oracle::area {

/// Piecewise constant texels (GT-N), px^2. `texels` in the piece's own offsets.
glm::dvec3 nearest_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                            const Homography<double>& texels);

/// What an integral costs, about, in texels: those of the piece and eight for each that its outline meets.
double texel_cost(const Polygon<double>& piece, const Homography<double>& texels);

}  // namespace zproof::oracle::area
