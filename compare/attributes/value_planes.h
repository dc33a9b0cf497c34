/// What plane equations in float32 make of values that are interpolated over a triangle (docs/bounds.md,
/// "Attributes").
#pragma once

#include "compare/attributes/surface.h"
#include "frame/precision.h"

namespace zproof {

/// A corner's weight is its inverse depth; in parallel projections 1.
struct ValuePlanes {
    double of_weights = unlimited;  ///< error of the plane through the weights
    double of_values = unlimited;   ///< of that through weights times values from -1 to 1
    double spread = 1;              ///< PlaneEquationBounds::spread
};

/// At the surface's pixel. Unlimited where a piece of next to no area may be drawn there.
ValuePlanes value_planes(const RasterPrecision& precision, const Surface& surface);

}  // namespace zproof
