/// The integral of a surface's albedo over a convex piece of a unit square.
#pragma once

#include <functional>
#include <span>

#include "filters/area/area_integral.h"
#include "filters/area/polygon.h"
#include "filters/area/surfaces.h"
#include "filters/area/texel_walk.h"

namespace zproof::oracle::area {

/// Adds the integral, px^2, of a piece of a unit square to the sum of each pixel that the square counts for:
/// under the reconstruction's weight and within its error (weight_of), for texels from 0 to 1; under a weight
/// of 1, exact of nearest texels and within 5e-9 of the area of bilinear ones. Piece and `texels` in offsets
/// from the square's middle.
void add_colour(const SurfaceColour& colour, const Polygon<double>& piece, const Homography<double>& texels,
                Reconstruction reconstruction, std::span<glm::dvec3> sums);

/// The weight of each texel in one pixel's sum, px^2: visit(cell, weight), some cells more than once.
using CellVisit = std::function<void(const Cell&, double)>;
void visit_weights(const Polygon<double>& piece, const Homography<double>& texels,
                   Reconstruction reconstruction, int pixel, const CellVisit& visit);

/// What an integral costs, about, in texels: those of the piece and eight for each that its outline meets.
double texel_cost(const Polygon<double>& piece, const Homography<double>& texels);

}  // namespace zproof::oracle::area
