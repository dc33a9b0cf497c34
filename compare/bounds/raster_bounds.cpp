#include "compare/bounds/raster_bounds.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/homogeneous.h"
#include "compare/bounds/roundings.h"
#include "compare/bounds/window_triangle.h"

namespace zproof {

namespace {

double snap_of(const RasterPrecision& precision) {
    switch (precision.snap) {
        case Snap::nearest:
            return std::ldexp(0.5, -precision.subpixel_bits);
        case Snap::truncate:
            return std::ldexp(1.0, -precision.subpixel_bits);
        case Snap::none:
            return 0;
    }
    return unlimited;
}

/// The reach of corners that clipping put on the window's sides, px.
double window_reach_px(const ViewFacts& facts) {
    return 2 * std::max(facts.scale.px_per_u * facts.largest_u, facts.scale.px_per_v * facts.largest_v);
}

/// Planes with a corner of the triangle beyond: near, far, and the sides of what is clipped to.
int cut_count(const ViewFacts& facts, const TriangleExtent& extent, Clipping clipping) {
    const Camera& c = facts.view.camera;
    const Window sides = clip_window_of(facts.view, clipping);
    std::array<bool, 6> cuts{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i], w = facts.perspective ? depth : 1;
        const glm::dvec2 at = facts.before_divide(extent, i);
        const std::array<bool, 6> beyond{depth<c.near_depth, depth> c.far_depth,
                                         at.x<sides.left * w, at.x> sides.right * w,
                                         at.y<sides.bottom * w, at.y> sides.top * w};
        for (std::size_t plane = 0; plane < cuts.size(); ++plane) cuts[plane] |= beyond[plane];
    }
    return int(std::ranges::count(cuts, true));
}

/// The farthest that a corner lies from the image's origin or the window's centre, px; `limit` where near may
/// cut the triangle or clipping keeps corners nearer.
double reach_px(const ViewFacts& facts, const TriangleExtent& extent, double limit) {
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i];
        if (!(depth >= facts.view.camera.near_depth)) return limit;
        const glm::dvec2 at = facts.before_divide(extent, i) / (facts.perspective ? depth : 1.0);
        reach = std::max({reach, facts.scale.px_per_u * (std::abs(at.x) + facts.largest_u),
                          facts.scale.px_per_v * (std::abs(at.y) + facts.largest_v)});
    }
    return std::min(reach, limit);
}

double largest_z(std::span<const WindowCorner> polygon) {
    double largest = 0;
    for (const WindowCorner& corner : polygon) largest = std::max(largest, std::abs(corner.z));
    return largest;
}

/// Only perspectives ask for it.
double highest_inverse_depth(std::span<const WindowCorner> polygon) {
    double highest = 0;
    for (const WindowCorner& corner : polygon) highest = std::max(highest, corner.inverse_depth);
    return highest;
}

/// Weights of which some are negative, by `negative` in all, reach beyond the sides that near and far made.
void add_reach_beyond_planes(TriangleBounds& bounds, const ViewFacts& facts,
                             std::span<const WindowCorner> polygon, double negative) {
    if (polygon.empty()) return;
    const auto [low, high] = std::ranges::minmax(polygon, {}, &WindowCorner::inverse_depth);
    const double range = high.inverse_depth - low.inverse_depth;
    const double beyond = range > 0 ? negative * range : 0;  // weights may be unlimited
    const Camera& c = facts.view.camera;
    bounds.near_slack += facts.perspective ? beyond * c.near_depth * c.near_depth : beyond;
    if (std::isfinite(c.far_depth))
        bounds.far_slack += facts.perspective ? c.far_depth * compounded(beyond * c.far_depth) : beyond;
}

}  // namespace

bool is_cut_at_a_corner(const ViewFacts& facts, const TriangleExtent& extent, const TriangleBounds& bounds) {
    const Camera& c = facts.view.camera;
    return std::ranges::any_of(extent.size.depth, [&](double depth) {
        return std::abs(depth - c.near_depth) <= bounds.near_slack ||
               std::abs(depth - c.far_depth) <= bounds.far_slack;
    });
}

RasterBounds::RasterBounds(const ViewFacts& facts, const RasterPrecision& precision)
    : precision_(precision), snap_px_(snap_of(precision)) {
    const double unit = unit_of(precision.transform);
    const double reach = window_reach_px(facts);
    background_eps_px_ = snap_px_ > 0 ? snap_px_ : gammas_of(unit)[8] * reach + narrowing_px(reach);
}

bool RasterBounds::has_plain_coverage() const {
    return precision_.edge_functions == EdgeFunctions::exact && precision_.barycentric_tolerance == 0 &&
           precision_.least_area_px2 == 0 && precision_.area_epsilon_px2 == 0;
}

/// Is depth itself interpolated from weights?
bool RasterBounds::has_plain_depth() const {
    return precision_.depth_buffer == DepthBuffer::camera_depth &&
           precision_.depth_interpolation == DepthInterpolation::barycentrics;
}

/// Is z kept in float64?
bool RasterBounds::is_wide() const {
    return precision_.depth_format == DepthFormat::float64 &&
           precision_.depth_buffer != DepthBuffer::camera_depth;
}

/// A corner's z is a float32, but where z is kept as the transform has it.
const Gammas& RasterBounds::gammas_of_z() const {
    return is_wide() ? gammas_of(precision_.transform) : single_gammas;
}

bool RasterBounds::is_homogeneous() const { return precision_.edge_functions == EdgeFunctions::homogeneous; }

bool RasterBounds::keeps_to_corners() const { return has_plain_depth() && has_plain_coverage(); }

/// The error is relative to the size of what is transformed.
double RasterBounds::transform_error(const ViewFacts& facts, int cuts) const {
    const double u = unit_of(precision_.transform);
    // float64: the fused matrix is built and applied in double: 3 (translation) + 3 + 3 (product of the two
    // matrices) + 4 (matrix times point) roundings. float32: entries rounded once, then 4, for each matrix.
    // Where the eye is subtracted first, 1 more, of a smaller size.
    const int fused = precision_.transform == Arithmetic::float64 ? 13 : 5;
    const int roundings = fused + 5 * (precision_.matrices - 1) + (precision_.origin == Origin::eye ? 1 : 0);
    // a new corner: 4 roundings of its place on the edge, each at most twice the corners' size, then 5
    return gamma(roundings + 13 * cuts, u) + facts.orthonormality;
}

const glm::dvec3& RasterBounds::transformed(const TriangleExtent& extent) const {
    return precision_.origin == Origin::eye ? extent.size.from_eye : extent.size.from_origin;
}

TriangleBounds RasterBounds::of_corners(const ViewFacts& facts, const TriangleExtent& extent,
                                        double transform) const {
    const glm::dvec3& moved = transformed(extent);
    const double lateral = transform * facts.scale.lateral_px(moved),
                 interpolation = has_plain_depth() ? gammas_of(precision_.interpolation)[8] : 0;
    TriangleBounds bounds;
    bounds.eps_base_px = snap_px_ + viewport_px(facts, extent) + (facts.perspective ? 0 : lateral);
    bounds.eps_per_inverse_depth = facts.perspective ? lateral : 0;
    bounds.displace_depth_alike();
    bounds.depth_factor = gamma(precision_.depth_roundings, unit_roundoff_float32) + interpolation;
    bounds.depth_absolute = transform * moved.z;
    // where corners lie on both sides of a parallel eye, roundings are shares of what cancels
    const auto [low, high] = std::ranges::minmax(extent.size.depth);
    if (facts.view.camera.near_depth < 0 && low < 0 && high > 0 && has_plain_depth())
        bounds.depth_absolute += bounds.depth_factor * extent.size.largest_depth();
    return bounds;
}

double RasterBounds::reach_limit_px(const ViewFacts& facts) const {
    return precision_.clipping == Clipping::view_volume ? window_reach_px(facts) : guard_band_px;
}

/// A homogeneous rasterizer clips nothing. In float64 a guard band costs next to nothing (docs/bounds.md).
int RasterBounds::counted_cuts(const ViewFacts& facts, const TriangleExtent& extent) const {
    const bool is_free =
        precision_.transform == Arithmetic::float64 && precision_.clipping == Clipping::guard_band;
    return is_homogeneous() || is_free ? 0 : cut_count(facts, extent, precision_.clipping);
}

/// Division, scale, offset; clipping's interpolation. In float64 the whole guard band costs 3e-11 px.
double RasterBounds::viewport_px(const ViewFacts& facts, const TriangleExtent& extent) const {
    if (is_homogeneous()) return 0;
    const double limit = reach_limit_px(facts);
    const bool is_coarse = precision_.transform == Arithmetic::float32;
    const double reach = is_coarse || narrows_corners() ? reach_px(facts, extent, limit) : limit;
    return gammas_of(precision_.transform)[8] * reach + narrowing_px(reach);
}

/// Do edge functions take a narrower type than the transform has?
bool RasterBounds::narrows_corners() const {
    return precision_.edge_functions != EdgeFunctions::exact &&
           precision_.edge_arithmetic == Arithmetic::float32 && precision_.transform == Arithmetic::float64;
}

/// That rounds a corner once more, but for one on a grid that the type holds.
double RasterBounds::narrowing_px(double reach_px) const {
    const double rounding = unit_roundoff_float32 * reach_px;
    return narrows_corners() && rounding > snap_px_ ? rounding : 0;
}

TriangleBounds RasterBounds::of(const ViewFacts& facts, const TriangleExtent& extent) const {
    const Gammas& gammas = gammas_of(precision_.transform);
    const double transform = transform_error(facts, counted_cuts(facts, extent));
    TriangleBounds bounds = of_corners(facts, extent, transform);
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + gammas[8] * extent.size.largest_depth();
    if (keeps_to_corners()) return bounds;
    const std::vector<WindowCorner> polygon =
        window_polygon(facts, extent, precision_.clipping, z_range(facts.view.camera, precision_));
    if (!has_plain_depth()) set_z(bounds, facts, extent, polygon, transform);
    if (!has_plain_coverage()) add_coverage(bounds, facts, extent, polygon);
    if (is_homogeneous()) add_homogeneous(bounds, facts, extent, transform);
    // pixels behind the eye are left out one by one, by their depths
    if (precision_.nothing_behind_the_eye && facts.view.camera.near_depth < 0)
        bounds.near_slack += bounds.inverse_depth_error;
    return bounds;
}

double RasterBounds::drift_px(const TriangleBounds& bounds, std::span<const WindowCorner> polygon) const {
    return bounds.eps_base_px - snap_px_ + bounds.eps_per_inverse_depth * highest_inverse_depth(polygon);
}

PlaneEquationBounds RasterBounds::z_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                           const ViewFacts& facts, const ZRange& z) const {
    PlaneEquationBounds bounds;
    if (precision_.depth_interpolation == DepthInterpolation::plane) {
        bounds = plane_equation_bounds(polygon, shift, facts.view);
    } else {
        const double z_max = largest_z(polygon);
        bounds.z_error = gammas_of_z()[4] * std::max(z_max, shift.least_z_term) +
                         gammas_of(precision_.interpolation)[8] * z_max;
    }
    bounds.z_error += decoding_error_of_z(z, largest_z(polygon));
    return bounds;
}

double RasterBounds::decoding_error_of_z(const ZRange& z, double z_max) const {
    const bool is_rounded = precision_.linearization == Arithmetic::float32 || is_wide();
    return precision_.depth_buffer == DepthBuffer::camera_depth || !is_rounded
               ? 0
               : gammas_of(precision_.linearization)[6] * (std::abs(z.offset) + z_max);
}

double RasterBounds::decoding_error(const ViewFacts& facts) const {
    const ZRange z = z_range(facts.view.camera, precision_);
    const double error = decoding_error_of_z(z, 1);
    return error > 0 ? error / std::abs(z.per_inverse_depth) : 0;
}

InverseDepthRange RasterBounds::storable(const ViewFacts& facts) const {
    if (precision_.depth_buffer == DepthBuffer::camera_depth) return any_inverse_depth;
    const ZRange z = z_range(facts.view.camera, precision_);
    // a float may pass the ends by the roundings of corners and mean; steps do not
    const double beyond = step_of_z(precision_.depth_format) == 0 ? gammas_of_z()[12] : 0;
    const auto [least, greatest] = std::minmax(
        {(-beyond - z.offset) / z.per_inverse_depth, (1 + beyond - z.offset) / z.per_inverse_depth});
    return {least, greatest};
}

void RasterBounds::set_z(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                         std::span<const WindowCorner> polygon, double transform) const {
    const Camera& c = facts.view.camera;
    const ZRange z = z_range(c, precision_);
    const CornerShift shift{
        .snap_px = snap_px_, .drift_px = drift_px(bounds, polygon), .least_z_term = z.least_term};
    const auto [z_error, spread] = z_bounds(polygon, shift, facts, z);
    const bool is_z = precision_.depth_buffer != DepthBuffer::camera_depth;
    const bool are_weights = precision_.depth_interpolation == DepthInterpolation::barycentrics;
    const auto [step, bias] =
        quantization(is_z ? precision_ : RasterPrecision{}, largest_z(polygon),
                     are_weights ? unit_of(precision_.interpolation) : unit_roundoff_float32);
    const double slope = std::abs(z.per_inverse_depth);
    bounds.inverse_depth_error = slope > 0 ? (z_error + step) / slope : unlimited;
    bounds.inverse_depth_bias = slope > 0 ? bias / z.per_inverse_depth : 0;
    bounds.depth_eps_base_px = snap_px_ + spread * (bounds.eps_base_px - snap_px_);
    bounds.depth_eps_per_inverse_depth = spread * bounds.eps_per_inverse_depth;
    if (facts.perspective && z.matrix_factor > 0) {
        // the matrix's row of z, whose error is a share of depth times inverse depth
        const double row = transform * (z.matrix_factor * transformed(extent).z + z.matrix_offset) / slope;
        bounds.depth_factor += spread * row;
        bounds.near_slack += row * c.near_depth;
        bounds.far_slack += std::isfinite(c.far_depth) ? row * c.far_depth : 0;
    }
    if (facts.perspective || precision_.depth_buffer == DepthBuffer::camera_depth) return;
    bounds.depth_absolute += gammas_of_z()[6] * z.matrix_offset / slope;
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + bounds.inverse_depth_error +
                                           std::abs(bounds.inverse_depth_bias) +
                                           gammas_of_z()[8] * extent.size.largest_depth();
}

void RasterBounds::add_coverage(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                                std::span<const WindowCorner> polygon) const {
    const double drift = snap_px_ + drift_px(bounds, polygon);
    const double edges = edge_functions_eps_px(facts, extent);
    const WindowAreas areas = window_areas(polygon, {drift, edges},
                                           {.edge_functions = precision_.edge_functions,
                                            .third_weight = precision_.third_weight,
                                            .unit = unit_of(precision_.edge_arithmetic),
                                            .area_epsilon_px2 = precision_.area_epsilon_px2,
                                            .may_vanish = is_cut_at_a_corner(facts, extent, bounds),
                                            .width = double(facts.view.width),
                                            .height = double(facts.view.height)});
    bounds.edge_rounding_px.fill(std::max(edges, areas.edges_px));
    bounds.eps_base_px += std::max(edges, areas.edges_px);
    add_tolerance(bounds, facts, extent, drift, areas);
    if (precision_.depth_interpolation == DepthInterpolation::barycentrics)
        add_weights(bounds, facts, areas, polygon);
    // of the smallest piece that displacement and clipping may leave
    bounds.may_be_missing = areas.least_px2 < precision_.least_area_px2;
}

/// Weights err, and may be negative where a point counts as inside by error or by tolerance.
void RasterBounds::add_weights(TriangleBounds& bounds, const ViewFacts& facts, const WindowAreas& areas,
                               std::span<const WindowCorner> polygon) const {
    const double negative = 2 * (areas.of_weights + 3 * precision_.barycentric_tolerance),
                 slope = std::abs(z_range(facts.view.camera, precision_).per_inverse_depth);
    // in a perspective a corner's weight in space is that in the image times depth over its own
    const double in_space = facts.perspective ? negative * highest_inverse_depth(polygon) : negative;
    const auto add = [](double& sum, double a, double b) {
        if (a > 0 && b > 0) sum += a * b;  // weights may be unlimited
    };
    add(bounds.depth_eps_base_px, bounds.depth_eps_base_px, negative);
    add(bounds.depth_eps_base_px, bounds.depth_eps_per_inverse_depth, in_space);
    add(facts.perspective ? bounds.depth_factor : bounds.depth_absolute, bounds.depth_absolute, in_space);
    const double of_corner =
        has_plain_depth() ? gamma(precision_.depth_roundings, unit_roundoff_float32) : gammas_of_z()[4];
    add(bounds.inverse_depth_error, negative,
        (of_corner + gammas_of(precision_.interpolation)[8]) * largest_z(polygon) / slope);
    if (negative > 0) add_reach_beyond_planes(bounds, facts, polygon, negative);
    // of a z-buffer's z it is a share of z, not of depth
    (has_plain_depth() ? bounds.depth_factor : bounds.inverse_depth_error) +=
        has_plain_depth() || areas.of_area == 0 ? areas.of_area : areas.of_area * largest_z(polygon) / slope;
    if (areas.of_weights > 0) bounds.inverse_depth_error += areas.of_weights * largest_z(polygon) / slope;
}

void RasterBounds::add_homogeneous(TriangleBounds& bounds, const ViewFacts& facts,
                                   const TriangleExtent& extent, double transform) const {
    const HomogeneousBounds own =
        homogeneous_bounds(facts, extent, transform * transformed(extent),
                           z_range(facts.view.camera, precision_), unit_of(precision_.edge_arithmetic));
    bounds.edge_rounding_px = own.edges_px;
    bounds.eps_base_px += std::ranges::max(own.edges_px);
    bounds.inverse_depth_error += own.inverse_depth_error;
    bounds.depth_factor += own.depth_factor;
    // pixels beyond near and far are cut one by one, by their depths
    const auto slack = [&](double depth) {
        const double e = own.inverse_depth_error;  // of depth itself where the view is parallel
        const double share = compounded(bounds.depth_factor + (facts.perspective ? e * depth : 0));
        if (std::isinf(share)) return share;
        return facts.perspective ? depth * share : (std::abs(depth) + e) * share + e;
    };
    const Camera& c = facts.view.camera;
    bounds.near_slack += slack(c.near_depth);
    bounds.far_slack += std::isfinite(c.far_depth) ? slack(c.far_depth) : 0;
}

double RasterBounds::edge_functions_eps_px(const ViewFacts& facts, const TriangleExtent& extent) const {
    const double unit = unit_of(precision_.edge_arithmetic);
    switch (precision_.edge_functions) {
        case EdgeFunctions::exact:
            return 0;
        case EdgeFunctions::from_corner:
            // 4 roundings of (x - x0) dy - (y - y0) dx, over |dx| + |dy|: a share of the larger difference
            return gammas_of(unit)[4] * reach_px(facts, extent, reach_limit_px(facts));
        case EdgeFunctions::window_coefficients:
            return 0;  // window_areas() has them
        case EdgeFunctions::homogeneous:
            return 0;  // add_homogeneous() has them
    }
    return unlimited;
}

/// A weight of minus the tolerance lies that share of the triangle's height outside its edge, and where two
/// are, that share of both sides beyond their corner. Such a place moves with the corners, and farther.
void RasterBounds::add_tolerance(TriangleBounds& bounds, const ViewFacts& facts, const TriangleExtent& extent,
                                 double drift_px, const WindowAreas& areas) const {
    if (precision_.barycentric_tolerance == 0) return;
    // what is divided by is the area and its epsilon
    const double epsilon = precision_.area_epsilon_px2 > 0
                               ? precision_.area_epsilon_px2 / std::max(0.0, areas.least_px2)
                               : 0,
                 tolerance = precision_.barycentric_tolerance * (1 + epsilon);
    const auto triangle = window_triangle(facts, extent);
    if (!triangle || !(tolerance < unlimited)) {
        bounds.eps_base_px += std::min(tolerance, 1.0) * 4 * reach_limit_px(facts);
        return;
    }
    bounds.weight_tolerance = tolerance;
    bounds.has_image_weights = facts.perspective && !is_homogeneous();
    bounds.eps_base_px += tolerance * (triangle->largest_height_px() + 4 * drift_px);
}

}  // namespace zproof
