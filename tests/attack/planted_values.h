/// Depths and attributes that are wrong for certain, by as little as is wanted.
#pragma once

#include "tests/attack/planting.h"

namespace zproof::attack {

/// A frame whose ids are true, and whose depths lie beyond what the promise permits by `factor`, on either
/// side. Triangles may be displaced by the promise's eps.
PlantedFrame with_wrong_depths(const Trial& trial, const BoundedPrecision& promise, DepthFrom from,
                               double factor);

/// Depths before all that comes within eps of the pixel: no triangle has them.
PlantedFrame with_depths_before_all(const Trial& trial, const BoundedPrecision& promise, double factor);

/// Barycentric coordinates beyond those of the triangle's part in the square, by as much as they change there
/// and the rounding of docs/bounds.md, times factor - 1. Everything else is true.
PlantedFrame with_wrong_weights(const Trial& trial, const BoundedPrecision& promise, double factor);

}  // namespace zproof::attack
