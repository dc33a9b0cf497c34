/// The integral of a surface's albedo over a convex piece of the image.
#pragma once

#include <functional>

#include "oracle/area/polygon.h"
#include "oracle/area/surfaces.h"
#include "oracle/area/texel_walk.h"

namespace zproof::oracle::area {

/// Piecewise constant texels (GT-N), px^2. `texels` in the piece's own offsets.
glm::dvec3 nearest_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                            const Homography<double>& texels);

/// Texels interpolated bilinearly (GT-B), px^2: within 5e-9 of the area, for texels from 0 to 1.
glm::dvec3 bilinear_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                             const Homography<double>& texels);

/// Texels interpolated bilinearly, under a weight (GT-G), within gaussian_error of the disk's weight. The
/// piece may be the whole square of radius 1 px.
glm::dvec3 gaussian_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                             const Homography<double>& texels);

/// Piecewise constant texels, under the same weight (GT-GN), within gaussian_error as well.
glm::dvec3 gaussian_integral_of_nearest(const SurfaceColour& colour, const Polygon<double>& piece,
                                        const Homography<double>& texels);

/// The weight of each texel in those integrals, px^2: visit(cell, weight), some cells more than once.
using CellVisit = std::function<void(const Cell&, double)>;
void visit_nearest_weights(const Polygon<double>& piece, const Homography<double>& texels,
                           const CellVisit& visit);
void visit_bilinear_weights(const Polygon<double>& piece, const Homography<double>& texels,
                            const CellVisit& visit);
void visit_gaussian_weights(const Polygon<double>& piece, const Homography<double>& texels,
                            const CellVisit& visit);
void visit_gaussian_weights_of_nearest(const Polygon<double>& piece, const Homography<double>& texels,
                                       const CellVisit& visit);

/// The weight of all of the disk: its mean's denominator.
double gaussian_total();

/// The most that a mean of texels from 0 to 1 can be off (docs/area-integral.md, "Gaussian").
inline constexpr double gaussian_error = 5.2e-5;

/// What an integral costs, about, in texels: those of the piece and eight for each that its outline meets.
double texel_cost(const Polygon<double>& piece, const Homography<double>& texels);

}  // namespace zproof::oracle::area
