#include "compare/bounds/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/bounds/plane_equation.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double guard_band_px = 32768;  ///< clipped vertices lie within it (D3D11.3 15.16: 16.8 coordinates)

double unit_of(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::float32 ? unit_roundoff_float32 : unit_roundoff_float64;
}

/// gamma(k) for the small k that every triangle asks for.
class Gammas {
  public:
    explicit Gammas(double unit) {
        for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = gamma(int(k), unit);
    }
    double operator[](std::size_t k) const { return values_[k]; }

  private:
    std::array<double, 17> values_{};
};
const Gammas single_gammas(unit_roundoff_float32), double_gammas(unit_roundoff_float64);
const Gammas& gammas_of(double unit) { return unit == unit_roundoff_float32 ? single_gammas : double_gammas; }

/// Is depth itself interpolated, and so never beyond the corners' depths?
bool interpolates_depth(const RasterPrecision& precision) {
    switch (precision.depth_buffer) {
        case DepthBuffer::camera_depth:
            return true;
        case DepthBuffer::reversed_z:
            return false;
    }
    return false;
}

/// What interpolation costs as a share of the depth.
double interpolation_factor(const RasterPrecision& precision) {
    switch (precision.depth_buffer) {
        case DepthBuffer::camera_depth:
            return gammas_of(unit_of(precision.interpolation))[8];
        case DepthBuffer::reversed_z:
            return 0;  // it is counted in z: set_reversed_z()
    }
    return unlimited;
}

glm::dvec3 abs_cross(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 p = glm::abs(a), q = glm::abs(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

double sum_abs(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

TriangleBounds bounds_of(const DepthTerms& terms) {
    TriangleBounds bounds;
    bounds.depth_eps_base_px = terms.eps_base_px;
    bounds.depth_eps_per_inverse_depth = terms.eps_per_inverse_depth;
    bounds.depth_factor = terms.factor;
    bounds.depth_absolute = terms.absolute;
    bounds.inverse_depth_error = terms.inverse_depth_error;
    bounds.plane_offset = terms.plane_offset;
    return bounds;
}

double largest_defect(const Camera& camera) {
    const glm::dmat3 axes(camera.right, camera.up, camera.back);
    const glm::dmat3 gram = glm::transpose(axes) * axes;
    double defect = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) defect = std::max(defect, std::abs(gram[i][j] - (i == j)));
    return defect + gamma(4, unit_roundoff_float64);
}

}  // namespace

double ViewBounds::lateral_px(const glm::dvec3& camera_abs) const {
    return scale_.lateral_px(exactly<double>(camera_abs));
}

ViewBounds::ViewBounds(const View& view, const Precision& precision)
    : view_(view),
      precision_(precision),
      perspective_(view.camera.projection == Projection::perspective),
      orthonormality_(largest_defect(view.camera)) {
    const Camera& c = view.camera;
    largest_u_ = std::max(std::abs(c.window.left), std::abs(c.window.right));
    largest_v_ = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    scale_ = {.px_per_u = view.width / (c.window.right - c.window.left),
              .px_per_v = view.height / (c.window.top - c.window.bottom),
              .slant_u = perspective_ ? largest_u_ : std::abs(c.shear.x),
              .slant_v = perspective_ ? largest_v_ : std::abs(c.shear.y)};
    direction_abs_ = scale_.slant_u * glm::abs(c.right) + scale_.slant_v * glm::abs(c.up) + glm::abs(c.back);
    origin_abs_ = perspective_ ? glm::dvec3(0) : largest_u_ * glm::abs(c.right) + largest_v_ * glm::abs(c.up);
    gauge_ = make_gauge();
    if (const auto* raster = std::get_if<RasterPrecision>(&precision)) {
        background_eps_px_ = std::ldexp(raster->snap == Snap::nearest ? 0.5 : 1.0, -raster->subpixel_bits);
    } else if (const auto* ray = std::get_if<RayPrecision>(&precision)) {
        set_aim(unit_of(ray->arithmetic));
    } else {
        set_aim(gamma(24, unit_roundoff_float64), std::get<PlaneRayPrecision>(precision).aim_offset_px);
    }
    common_terms_ = common_terms();
}

Gauge ViewBounds::make_gauge() const {
    const Camera& c = view_.camera;
    const glm::dvec3 eye(c.eye_world);
    const auto all = [](const glm::dvec3& v) { return exactly<double>(v); };
    return {.projection = c.projection,
            .eye = all(eye),
            .eye_abs = all(glm::abs(eye)),
            .back = all(c.back),
            .axes_abs = {all(glm::abs(c.right)), all(glm::abs(c.up)), all(glm::abs(c.back))},
            .direction = all(c.shear.x * c.right + c.shear.y * c.up - c.back),
            .direction_abs = all(direction_abs_),
            .origin_abs = all(origin_abs_)};
}

void ViewBounds::set_aim(double unit, double offset_px) {
    const Camera& c = view_.camera;
    const std::array axes{c.right, c.up, c.back};
    const glm::dvec3 origin_world = glm::abs(glm::dvec3(c.eye_world)) + origin_abs_;
    glm::dvec3 direction_error, origin_error;  // per camera axis
    for (int i = 0; i < 3; ++i) {
        direction_error[i] = unit * glm::dot(glm::abs(axes[size_t(i)]), direction_abs_);
        origin_error[i] = perspective_ ? 0 : unit * glm::dot(glm::abs(axes[size_t(i)]), origin_world);
    }
    aim_px_ = offset_px + lateral_px(perspective_ ? direction_error : origin_error);
    aim_px_per_depth_ = perspective_ ? 0 : lateral_px(direction_error);
    aim_depth_relative_ = direction_error.z;
    aim_depth_absolute_ = origin_error.z;
    background_eps_px_ = aim_px_;
}

TriangleExtent ViewBounds::extent_of(const CornersWorld& p_world) const {
    const glm::dvec3 p[] = {glm::dvec3(p_world[0]), glm::dvec3(p_world[1]), glm::dvec3(p_world[2])};
    const glm::dvec3 eye(view_.camera.eye_world);
    return {{p[0] - eye, p[1] - eye, p[2] - eye},
            gauge_({exactly<double>(p[0]), exactly<double>(p[1]), exactly<double>(p[2])})};
}

TriangleBounds ViewBounds::of(const TriangleExtent& extent) const {
    TriangleBounds bounds =
        std::visit([&](const auto& precision) { return bounds_by(extent, precision); }, precision_);
    const CornerDepths corners = corner_depths(extent);
    bounds.nearest = corners.nearest;
    bounds.farthest = corners.farthest;
    return bounds;
}

DepthTerms ViewBounds::depth_terms(const TriangleExtent& extent) const {
    if (const auto* raster = std::get_if<RasterTerms>(&common_terms_)) return raster->of(extent.size);
    if (const auto* ray = std::get_if<RayTerms>(&common_terms_)) {
        DepthTerms terms = ray->of(extent.size);
        terms.factor += framing_by(std::get<RayPrecision>(precision_));
        return terms;
    }
    return of(extent).depth_terms();
}

auto ViewBounds::corner_depths(const TriangleExtent& extent) const -> CornerDepths {
    const Camera& c = view_.camera;
    const auto [low, high] = std::minmax({extent.size.depth[0], extent.size.depth[1], extent.size.depth[2]});
    return {std::clamp(low, c.near_depth, c.far_depth), std::clamp(high, c.near_depth, c.far_depth)};
}

bool ViewBounds::keeps_to_corners() const {
    const auto* raster = std::get_if<RasterPrecision>(&precision_);
    return raster && interpolates_depth(*raster);
}

/// The error is relative to the size of what is transformed.
double ViewBounds::transform_error(const RasterPrecision& precision, int cuts) const {
    const double u = unit_of(precision.transform);
    // float64: the fused matrix is built and applied in double: 3 (translation) + 3 + 3 (product of the two
    // matrices) + 4 (matrix times point) roundings. float32: entries rounded once, then 4. Where the eye is
    // subtracted first, 1 more, of a smaller size.
    const int roundings =
        (precision.transform == Arithmetic::float64 ? 13 : 5) + (precision.origin == Origin::eye ? 1 : 0);
    // a new corner: 4 roundings of its place on the edge, each at most twice the corners' size, then 5
    const double rounding =
        cuts == 0 ? gammas_of(u)[std::size_t(roundings)] : gamma(roundings + 13 * cuts, u);
    return rounding + orthonormality_;
}

/// A rasterizer's transform in double, into a guard band, is as coarse for one triangle as for another.
CommonTerms ViewBounds::common_terms() const {
    if (const auto* ray = std::get_if<RayPrecision>(&precision_)) {
        return ray_terms(*ray);
    } else if (const auto* raster = std::get_if<RasterPrecision>(&precision_)) {
        if (raster->transform == Arithmetic::float64 && raster->clipping == Clipping::guard_band &&
            interpolates_depth(*raster))
            return raster_terms(*raster, transform_error(*raster, 0), double_gammas[8] * guard_band_px);
    }
    return {};
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const RasterPrecision& precision) const {
    const double u = unit_of(precision.transform);
    const bool in_volume = precision.clipping == Clipping::view_volume;
    const double transform = transform_error(precision, in_volume ? cut_count(extent) : 0);
    // division, scale, offset; clipping's interpolation. In float64 the whole guard band costs 3e-11 px
    const bool is_coarse = precision.transform == Arithmetic::float32;
    const double limit = in_volume ? window_reach_px() : guard_band_px;
    const double viewport = gammas_of(u)[8] * (is_coarse ? reach_px(extent, limit) : limit);
    TriangleBounds bounds = bounds_of(raster_terms(precision, transform, viewport).of(extent.size));
    bounds.eps_base_px = bounds.depth_eps_base_px;
    bounds.eps_per_inverse_depth = bounds.depth_eps_per_inverse_depth;
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + gammas_of(u)[8] * extent.largest_depth();
    switch (precision.depth_buffer) {
        case DepthBuffer::camera_depth:
            break;
        case DepthBuffer::reversed_z:
            set_reversed_z(bounds, extent);
    }
    return bounds;
}

RasterTerms ViewBounds::raster_terms(const RasterPrecision& precision, double transform,
                                     double viewport) const {
    return {
        .scale = scale_,
        .projection = view_.camera.projection,
        .base_px = background_eps_px_ + viewport,  // snapping first
        .transform = transform,
        .factor = gamma(precision.depth_roundings, unit_roundoff_float32) + interpolation_factor(precision),
        .size =
            precision.origin == Origin::eye ? RasterTerms::Size::from_eye : RasterTerms::Size::from_origin};
}

void ViewBounds::set_reversed_z(TriangleBounds& bounds, const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    const double snap = background_eps_px_;
    const std::vector<WindowCorner> polygon = window_polygon(view_, extent);
    double highest = 0;  // inverse depth; only perspectives ask for it
    for (const WindowCorner& corner : polygon) highest = std::max(highest, corner.z / z_per_inverse_depth(c));
    const double drift_base = bounds.eps_base_px - snap, drift_per = bounds.eps_per_inverse_depth;
    const CornerShift shift{.snap_px = snap, .drift_px = drift_base + drift_per * highest};
    const auto [z_error, spread] = plane_equation_bounds(polygon, shift, view_);
    bounds.inverse_depth_error = z_error / z_per_inverse_depth(c);
    bounds.depth_eps_base_px = snap + spread * drift_base;
    bounds.depth_eps_per_inverse_depth = spread * drift_per;
    if (perspective_) return;
    // z is made of far - depth
    bounds.depth_absolute += gamma(6, unit_roundoff_float32) * std::abs(c.far_depth);
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + bounds.inverse_depth_error +
                                           gamma(8, unit_roundoff_float32) * extent.largest_depth();
}

double ViewBounds::window_reach_px() const {
    return 2 * std::max(scale_.px_per_u * largest_u_, scale_.px_per_v * largest_v_);
}

int ViewBounds::cut_count(const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    std::array<bool, 6> cuts{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i], w = perspective_ ? depth : 1;
        const double x = glm::dot(c.right, extent.v_world[i]) - c.shear.x * depth;
        const double y = glm::dot(c.up, extent.v_world[i]) - c.shear.y * depth;
        const std::array<bool, 6> beyond{depth<c.near_depth, depth> c.far_depth,
                                         x<c.window.left * w, x> c.window.right * w,
                                         y<c.window.bottom * w, y> c.window.top * w};
        for (std::size_t plane = 0; plane < cuts.size(); ++plane) cuts[plane] |= beyond[plane];
    }
    return int(std::ranges::count(cuts, true));
}

double ViewBounds::reach_px(const TriangleExtent& extent, double limit) const {
    const Camera& c = view_.camera;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i];
        if (!(depth >= c.near_depth)) return limit;
        const double x = glm::dot(c.right, extent.v_world[i]), y = glm::dot(c.up, extent.v_world[i]);
        const double u = perspective_ ? x / depth : x - c.shear.x * depth;
        const double v = perspective_ ? y / depth : y - c.shear.y * depth;
        reach = std::max({reach, scale_.px_per_u * (std::abs(u) + largest_u_),
                          scale_.px_per_v * (std::abs(v) + largest_v_)});
    }
    return std::min(reach, limit);
}

double ViewBounds::edge_test_eps_px(const TriangleExtent& extent, int edge, double unit) const {
    const glm::dvec3& from = extent.v_world[size_t((edge + 1) % 3)];
    const glm::dvec3& to = extent.v_world[size_t((edge + 2) % 3)];
    const Camera& c = view_.camera;
    const double u_per_px = 1 / scale_.px_per_u, v_per_px = 1 / scale_.px_per_v;
    const glm::dvec3 difference = to - from, sum = to + from;
    const glm::dvec3 sum_abs = glm::abs(sum) + 2.0 * origin_abs_;
    const double error = gammas_of(unit)[7] * glm::dot(abs_cross(difference, sum_abs), direction_abs_);
    // |d/dx| + |d/dy| of (difference x sum) . direction
    const glm::dvec3 toward_x = u_per_px * c.right, toward_y = v_per_px * c.up;
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    const glm::dvec3 moment =
        perspective_ ? glm::cross(difference, sum) : 2.0 * glm::cross(direction, difference);
    const double gradient = std::abs(glm::dot(moment, toward_x)) + std::abs(glm::dot(moment, toward_y));
    return gradient > 0 ? error / gradient : 0;  // an edge without extent in the image bounds no area
}

/// The terms of the hit itself; rounding it to float32 may lose more.
RayTerms ViewBounds::ray_terms(const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    return {.scale = scale_,
            .projection = view_.camera.projection,
            .unit = u,
            .of_products = gammas_of(u)[8],
            .factor = gammas_of(u)[4] + aim_depth_relative_,
            .aim_px = aim_px_,
            .aim_px_per_depth = aim_px_per_depth_,
            .aim_absolute = aim_depth_absolute_};
}

/// Frames hold float32: a wider depth is rounded once more on its way there.
double ViewBounds::framing_by(const RayPrecision& precision) {
    return precision.arithmetic == Arithmetic::float64 ? unit_roundoff_float32 : 0;
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    TriangleBounds bounds = bounds_of(ray_terms(precision).of(extent.size));
    const double corner = u * scale_.lateral_px(extent.size.from_eye);
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();
    double edges = 0;
    for (int edge = 0; edge < 3; ++edge) edges = std::max(edges, edge_test_eps_px(extent, edge, u));
    // the robust test admits barycentrics down to -2u: a step of at most 2u (|v_i| + |q|)
    bounds.eps_base_px = aim + edges + (perspective_ ? 0 : 5 * corner);
    bounds.eps_per_inverse_depth = perspective_ ? 5 * corner : 0;
    const auto slack = [&](double plane_depth) {
        const double share = compounded(u + bounds.depth_factor + bounds.plane_offset * plane_depth);
        return std::isinf(share) ? share : plane_depth * share + bounds.depth_absolute;
    };
    const Camera& c = view_.camera;
    bounds.near_slack = slack(c.near_depth);
    bounds.far_slack = std::isfinite(c.far_depth) ? slack(c.far_depth) : 0;
    bounds.depth_factor += framing_by(precision);
    return bounds;
}

double ViewBounds::ray_reach(const TriangleExtent& extent) const {
    double reach = 0;
    for (const glm::dvec3& v : extent.v_world) reach = std::max(reach, sum_abs(v));
    if (perspective_) return reach;
    const Camera& c = view_.camera;
    const double start = 3 * std::max(std::abs(c.near_depth), std::abs(c.far_depth)) +
                         (c.window.right - c.window.left) + (c.window.top - c.window.bottom);
    return reach + sum_abs(origin_abs_) + start * sum_abs(direction_abs_);
}

double ViewBounds::plane_test_error(const TriangleExtent& extent, const PlaneRayPrecision& precision) const {
    constexpr double u = unit_roundoff_float64, sqrt3 = 1.7320508075688773;
    const auto& v = extent.v_world;
    const glm::dvec3 side1 = v[0] - v[1], side2 = v[2] - v[1];
    const double product = glm::length(side1) * glm::length(side2);
    const double area = glm::length(glm::cross(side1, side2));
    const double sine = product > 0 ? std::max(area / product, precision.least_corner_sine) : 1;
    const double diameter = std::max({glm::length(side1), glm::length(side2), glm::length(v[2] - v[0])});
    const double reach = ray_reach(extent);
    const double offset = sqrt3 * gamma(5, u) / sine * diameter + gamma(8, u) * reach;
    const double error = sqrt3 * (offset + gamma(2, u) * reach + 3 * gamma(3, u) * diameter);
    const bool may_graze = extent.size.plane.volume <= 2 * precision.least_grazing_sine * area * reach;
    return error + (may_graze ? precision.least_grazing_sine * reach : 0);
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const PlaneRayPrecision& precision) const {
    constexpr double u = unit_roundoff_float64;
    const double corner = u * scale_.lateral_px(extent.size.from_eye);
    const double inside = lateral_px(glm::dvec3(plane_test_error(extent, precision)));
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();

    TriangleBounds bounds;
    bounds.eps_base_px = aim + (perspective_ ? 0 : corner + inside);
    bounds.eps_per_inverse_depth = perspective_ ? corner + inside : 0;
    bounds.depth_eps_base_px = aim + (perspective_ ? 0 : corner);
    bounds.depth_eps_per_inverse_depth = perspective_ ? corner : 0;

    // where the ray meets the plane as for Pluecker rays, the normal's length taken out: 10 roundings in each
    // product; then -back . (origin + t d)
    const Camera& c = view_.camera;
    const PlaneSize& size = extent.size.plane;
    const auto over_volume = [&](double sum) {
        return size.volume > 0 ? gamma(10, u) * sum / size.volume : unlimited;
    };
    const double volume_factor = over_volume(size.volume_abs),
                 numerator_error = over_volume(size.numerator_abs);
    const double along = gamma(8, u) * glm::dot(glm::abs(c.back), direction_abs_) +
                         orthonormality_ * (1 + scale_.slant_u + scale_.slant_v);
    const double hit_factor = gamma(8, u) + aim_depth_relative_ + volume_factor + along;
    bounds.depth_factor = hit_factor + precision.depth_relative;
    bounds.depth_absolute = u * extent.size.from_eye.z + aim_depth_absolute_;
    if (perspective_) {
        bounds.plane_offset = numerator_error;
    } else {
        bounds.depth_absolute += numerator_error * (1 + compounded(volume_factor)) +
                                 (gamma(8, u) * sum_abs(c.back) + orthonormality_) * ray_reach(extent);
    }
    const auto slack = [&](double plane_depth) {
        const double share = compounded(hit_factor + bounds.plane_offset * plane_depth);
        if (std::isinf(share)) return share;
        const double clip = precision.clip_relative * std::abs(plane_depth) +
                            (perspective_ ? 0 : precision.clip_of_reach * ray_reach(extent));
        return std::abs(plane_depth) * share + bounds.depth_absolute + clip;
    };
    bounds.near_slack = slack(c.near_depth);
    bounds.far_slack = std::isfinite(c.far_depth) ? slack(c.far_depth) : 0;
    if (!perspective_) bounds.depth_absolute += precision.depth_of_range * (c.far_depth - c.near_depth);
    return bounds;
}

LocalBounds TriangleBounds::at(double inverse_depth, double gradient) const {
    return BoundsOnPlane(*this, gradient).at(inverse_depth);
}

BoundsOnPlane::BoundsOnPlane(const TriangleBounds& b, double gradient)
    : corners_(b.nearest, b.farthest),
      eps_px_(b.eps_base_px, b.eps_per_inverse_depth, gradient, corners_.highest),
      depth_eps_px_(b.depth_eps_base_px, b.depth_eps_per_inverse_depth, gradient, corners_.highest),
      depth_factor_(b.depth_factor),
      plane_offset_(b.plane_offset),
      depth_relative_(compounded(b.depth_factor)),
      depth_absolute_(b.depth_absolute),
      inverse_depth_error_(b.inverse_depth_error) {}

}  // namespace zproof
