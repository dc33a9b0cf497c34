/// What a renderer's declared arithmetic costs a value that it interpolates, beside the displacement
/// (docs/bounds.md, "Attributes").
#pragma once

#include "compare/attributes/interpolation_range.h"
#include "compare/attributes/surface.h"
#include "frame/precision.h"

namespace zproof {

struct InterpolationErrors {
    double relative = 0;          ///< of every product of a weight and a value
    double of_products = 0;       ///< the same without the errors of weights that leave them above 0
    double of_corners = 0;        ///< relative, of the weight that a corner brings
    double of_weights = 0;        ///< sum of the weights' own errors, as a share of their sum
    double negative = 0;          ///< what weights as computed may be below 0 in all, as a share of their sum
    double underflow = 0x1p-126;  ///< what results that become 0 may lack
    enum class Sum { one, at_most_one } of_shares = Sum::one;  ///< what the weights' shares may add up to
    SampledPlaces sampled = SampledPlaces::on_triangle;
    bool may_be_anything = false;  ///< no number as well: a plane of which rounding may take all the area
};

/// Does the declaration say how values are interpolated in such a projection?
bool promises_attributes(const Precision& precision, Projection projection);
/// The precision of a camera depth that is interpolated beside other values.
Precision varying_precision(const Precision& precision);

/// The precision must promise attributes, and the surface be measured by the bounds of varying_precision().
/// `depth` is what the frame shows there.
InterpolationErrors interpolation_errors(const Precision& precision, const Surface& surface, double depth);

}  // namespace zproof
