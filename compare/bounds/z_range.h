/// z of a depth buffer as a function of inverse depth (docs/bounds.md, "A z-buffer").
#pragma once

#include "frame/precision.h"
#include "scenes/view.h"

namespace zproof {

/// z = offset + per_inverse_depth * inverse_depth, where inverse depth is 1/depth for perspective and -depth
/// for parallel projections. Affine in the image. Between near and far, z of a depth buffer is in [0, 1].
struct ZRange {
    double offset = 0, per_inverse_depth = 1;
    /// The projection matrix's factor of depth, and what it adds to it, in units of z.
    double matrix_factor = 0, matrix_offset = 0;
    /// No corner's z is rounded as if it were smaller: the viewport adds 1/2 to what spans [-1, 1].
    double least_term = 0;

    double at(double inverse_depth) const { return offset + per_inverse_depth * inverse_depth; }
};

/// A buffer that holds camera depth interpolates near / depth, or depth itself in parallel projections.
/// Parallel projections need a finite far for the others; NaN without.
ZRange z_range(const Camera& camera, const RasterPrecision& precision);

/// A step of z in [0, 1]; 0 where a float is stored.
double step_of_z(DepthFormat format);

/// What storing z does to it: at most `error` beside z + bias.
struct Quantization {
    double error = 0, bias = 0;
};
/// How a z of at most z_max becomes a step, in arithmetic of this roundoff.
Quantization quantization(const RasterPrecision& precision, double z_max, double unit);

}  // namespace zproof
