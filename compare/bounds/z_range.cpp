#include "compare/bounds/z_range.h"

#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

/// z as the projection matrix has it, in [0, 1].
ZRange perspective_range(const Camera& c, const RasterPrecision& precision) {
    const bool ends_at_far = precision.matrix_far == MatrixFar::finite && std::isfinite(c.far_depth);
    const double n = c.near_depth, share = ends_at_far ? c.far_depth / (c.far_depth - n) : 1;
    if (precision.depth_buffer == DepthBuffer::standard_z)
        return {.offset = share, .per_inverse_depth = -n * share};
    return {.offset = 1 - share, .per_inverse_depth = n * share};
}

ZRange parallel_range(const Camera& c, const RasterPrecision& precision) {
    const double per_depth = 1 / (c.far_depth - c.near_depth);
    if (precision.depth_buffer == DepthBuffer::standard_z)
        return {.offset = -c.near_depth * per_depth, .per_inverse_depth = -per_depth};
    return {.offset = c.far_depth * per_depth, .per_inverse_depth = per_depth};
}

}  // namespace

ZRange z_range(const Camera& camera, const RasterPrecision& precision) {
    const bool perspective = camera.projection == Projection::perspective;
    if (precision.depth_buffer == DepthBuffer::camera_depth)
        return {.offset = 0, .per_inverse_depth = perspective ? camera.near_depth : -1};
    ZRange z = perspective ? perspective_range(camera, precision) : parallel_range(camera, precision);
    const double shift = precision.clip_range == ClipRange::minus_one_to_one ? 0.5 : 0;
    const double constant = std::abs(z.offset - shift), slope = std::abs(z.per_inverse_depth);
    z.matrix_factor = perspective ? constant : slope;
    z.matrix_offset = perspective ? slope : constant;
    z.least_term = 2 * shift;
    return z;
}

double step_of_z(DepthFormat format) {
    switch (format) {
        case DepthFormat::float32:
        case DepthFormat::float64:
            return 0;  // one of the roundings of z
        case DepthFormat::unorm16:
            return 1 / (std::exp2(16) - 1);
        case DepthFormat::unorm24:
            return 1 / (std::exp2(24) - 1);
        case DepthFormat::unorm32:
            return 1 / (std::exp2(32) - 1);
    }
    return 0;
}

Quantization quantization(const RasterPrecision& precision, double z_max, double unit) {
    const double step = step_of_z(precision.depth_format);
    if (step == 0) return {};
    // z times the number of steps is rounded, and so is that number of 32 bits; the nearest is found by
    // adding 1/2
    const int scaling = precision.depth_format == DepthFormat::unorm32 ? 2 : 1;
    switch (precision.depth_rounding) {
        case DepthRounding::either:
            return {.error = step};
        case DepthRounding::nearest:
            return {.error = step / 2 + gamma(scaling + 1, unit) * (z_max + step)};
        case DepthRounding::truncate:
            return {.error = step / 2 + gamma(scaling, unit) * z_max, .bias = -step / 2};
    }
    return {};
}

}  // namespace zproof
