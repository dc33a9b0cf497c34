/// What a renderer's declared arithmetic costs a value that it interpolates, beside the displacement
/// (docs/bounds.md, "Attributes").
#pragma once

#include "compare/attributes/interpolation_range.h"
#include "compare/attributes/surface.h"
#include "frame/precision.h"

namespace zproof {

struct InterpolationErrors {
    double relative = 0;    ///< of every product of a weight and a value
    double of_weights = 0;  ///< sum of the weights' own errors, as a share of their sum
    SampledPlaces sampled = SampledPlaces::on_triangle;
};

/// Does the declaration say how values are interpolated in such a projection?
bool promises_attributes(const Precision& precision, Projection projection);
/// The precision of a camera depth that is interpolated beside other values.
Precision varying_precision(const Precision& precision);

/// The precision must promise attributes, and the surface be measured by the bounds of varying_precision().
InterpolationErrors interpolation_errors(const Precision& precision, const Surface& surface);

}  // namespace zproof
