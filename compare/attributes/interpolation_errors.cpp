#include "compare/attributes/interpolation_errors.h"

#include <algorithm>
#include <cmath>

#include "compare/attributes/value_planes.h"
#include "compare/bounds/ray_bounds.h"
#include "compare/bounds/roundings.h"
#include "compare/bounds/window_triangle.h"

namespace zproof {

namespace {

/// What 1 / depth costs, twice: value / depth is such a sum as well.
double relative_of_depth(const Surface& s) {
    return 2 * (s.bounds.depth_factor + s.bounds.depth_share) + unit_roundoff_float32;
}

/// A corner's weight is 1 / depth, the same in both sums.
double of_corners(const Surface& s) {
    return s.facts.perspective ? s.bounds.depth_absolute / s.bounds.nearest : 0;
}

bool is_cut(const RasterPrecision& precision, const Surface& s) {
    const auto triangle = window_triangle(s.facts, s.extent);
    if (!triangle) return true;
    const glm::dvec2 size{s.facts.view.width, s.facts.view.height};
    const bool whole = precision.clipping == Clipping::view_volume;
    const glm::dvec2 reach = whole ? size / 2.0 : glm::dvec2(guard_band_px);
    return !std::ranges::all_of(triangle->corner_px, [&](const glm::dvec2& corner) {
        const glm::dvec2 from_middle = glm::abs(corner - size / 2.0);
        return from_middle.x <= reach.x && from_middle.y <= reach.y;
    });
}

bool has_exact_coverage(const RasterPrecision& precision) {
    return precision.edge_functions == EdgeFunctions::exact && precision.barycentric_tolerance == 0;
}

/// Weights in the window are at least -tolerance. Perspective divides them by their corners' depths, and
/// their sum becomes 1 / depth.
double negative_weights(const RasterPrecision& precision, const Surface& s, double depth) {
    const double tolerance = 3 * precision.barycentric_tolerance;
    if (!s.facts.perspective || tolerance == 0) return tolerance;
    return tolerance * std::max(1.0, depth / s.bounds.nearest);
}

double of_clipping(const RasterPrecision& precision, const Surface& s) {
    const bool cuts = precision.edge_functions != EdgeFunctions::homogeneous && is_cut(precision, s);
    return cuts ? gamma(4 * 6, unit_of(precision.transform)) : 0;
}

/// A value is a quotient of planes, of weights times values by that of weights; or two corners' shares are
/// such quotients, and blend the corners' values. It keeps to no mean.
InterpolationErrors errors_of_planes(const RasterPrecision& precision, const Surface& s) {
    const ValuePlanes planes = value_planes(precision, s);
    const double largest = s.facts.perspective ? 1 / s.bounds.nearest : 1,
                 least = s.facts.perspective ? s.least_inverse_depth : 1;
    if (!std::isfinite(planes.of_values) || !(least > planes.of_weights)) return {.may_be_anything = true};
    const double of_blend = gamma(12, unit_roundoff_float32);
    return {.relative =
                relative_of_depth(s) + 2 * planes.of_weights / least + of_blend + of_clipping(precision, s),
            .of_products = unlimited,
            .of_corners = of_corners(s),
            .of_weights = (2 * planes.of_weights + planes.of_values) / least,
            .negative = (planes.spread - 1) / 2 * largest / least,
            .underflow = 0x1p-126 + underflow_of_plane / least,
            .sampled = SampledPlaces::anywhere};
}

InterpolationErrors errors_of(const RasterPrecision& precision, const Surface& s, double depth) {
    if (precision.depth_interpolation == DepthInterpolation::plane) return errors_of_planes(precision, s);
    const double mean =
        gamma(precision.depth_roundings, unit_roundoff_float32) + gammas_of(precision.interpolation)[8];
    InterpolationErrors errors{.relative = relative_of_depth(s),
                               .of_products = 2 * mean + unit_roundoff_float32,
                               .of_corners = of_corners(s),
                               .negative = negative_weights(precision, s, depth)};
    const double clipping = of_clipping(precision, s);
    errors.relative += clipping;
    errors.of_products += clipping;
    if (precision.area_epsilon_px2 > 0) errors.of_shares = InterpolationErrors::Sum::at_most_one;
    if (has_exact_coverage(precision)) return errors;
    errors.sampled = SampledPlaces::anywhere;
    if (s.bounds.inverse_depth_error == 0) return errors;
    const bool is_known = s.facts.perspective && s.least_inverse_depth > 0;
    errors.of_weights = is_known ? s.bounds.inverse_depth_error / s.least_inverse_depth : unlimited;
    return errors;
}

/// By the pixel's own ray.
double weights_error_at(const RayPrecision& precision, const Surface& s) {
    const auto in_glm = [](const Vector3<double>& v) { return glm::dvec3(v.x, v.y, v.z); };
    std::array<glm::dvec3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = glm::dvec3(s.p_world()[i]) - in_glm(s.ray.origin);
    return weights_error(precision, v, glm::dvec3(0), abs(in_glm(s.ray.direction)));
}

/// A Pluecker test lets weights down to -2 u of their sum.
InterpolationErrors errors_of(const RayPrecision& precision, const Surface& s, double) {
    const double unit = unit_of(precision.arithmetic), products = gamma(8, unit) + unit_roundoff_float32;
    return {.relative = products,
            .of_products = products,
            .of_weights = s.least_sum > 0 ? weights_error_at(precision, s) / s.least_sum : unlimited,
            .negative = 3 * (precision.barycentric_tolerance + 2 * unit),
            .sampled = SampledPlaces::anywhere};
}

/// Both sums err by depth_relative: their quotient by (1 + r) / (1 - r) at most. Nothing says that what
/// depth_absolute does is the corners'.
InterpolationErrors errors_of(const BoundedPrecision& precision, const Surface& s, double) {
    const double r = precision.depth_relative;
    return {.relative = relative_of_depth(s) + 2 * of_corners(s),
            .of_products = 2 * r / (1 + r) + unit_roundoff_float32};
}

/// It promises nothing (promises_attributes()).
InterpolationErrors errors_of(const PlaneRayPrecision&, const Surface&, double) {
    return {.relative = unlimited, .of_products = unlimited, .of_weights = unlimited};
}

}  // namespace

bool promises_attributes(const Precision& precision, Projection projection) {
    if (const auto* raster = std::get_if<RasterPrecision>(&precision)) {
        if (raster->depth_interpolation == DepthInterpolation::plane) return has_exact_coverage(*raster);
        return projection == Projection::perspective || raster->edge_functions == EdgeFunctions::exact;
    }
    if (const auto* bounded = std::get_if<BoundedPrecision>(&precision)) return bounded->depth_relative < 1;
    return !std::holds_alternative<PlaneRayPrecision>(precision);
}

Precision varying_precision(const Precision& precision) {
    Precision varying = precision;
    if (auto* raster = std::get_if<RasterPrecision>(&varying))
        raster->depth_buffer = DepthBuffer::camera_depth;
    return varying;
}

InterpolationErrors interpolation_errors(const Precision& precision, const Surface& surface, double depth) {
    return std::visit([&](const auto& p) { return errors_of(p, surface, depth); }, precision);
}

}  // namespace zproof
