/// Depth of a triangle's plane, also beyond its corners: what a renderer has that extrapolates.
#pragma once

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// The depths that the plane may have at an offset (px, x right, y down) from the centre of the pixel that
/// the triangle was seen at, bounds included. Unlimited where the plane is not known there.
ReportedDepth plane_depth(const Neighbour& triangle, Projection projection, const glm::dvec2& offset_px);

}  // namespace zproof
