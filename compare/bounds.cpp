#include "compare/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/plane_equation.h"
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

glm::dvec3 abs_cross(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 p = glm::abs(a), q = glm::abs(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

double sum_abs(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

double largest_defect(const Camera& camera) {
    const glm::dmat3 axes(camera.right, camera.up, camera.back);
    const glm::dmat3 gram = glm::transpose(axes) * axes;
    double defect = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) defect = std::max(defect, std::abs(gram[i][j] - (i == j)));
    return defect + gamma(4, unit_roundoff_float64);
}

}  // namespace

PlaneError::PlaneError(const PlaneSize& size)
    : rounding_(double_gammas[16]),
      condition_(size.volume_abs / size.volume),
      numerator_(size.numerator_abs / size.volume),
      of_origin_(2 * size.origin_error / size.volume) {
    is_known_ = rounding_ * condition_ < 0.5;
}

double TriangleExtent::largest_depth() const {
    return std::max({std::abs(depth[0]), std::abs(depth[1]), std::abs(depth[2])});
}

double ViewBounds::lateral_px(const glm::dvec3& camera_abs) const {
    return std::max(px_per_u_ * (camera_abs.x + slant_u_ * camera_abs.z),
                    px_per_v_ * (camera_abs.y + slant_v_ * camera_abs.z));
}

ViewBounds::ViewBounds(const View& view, const Precision& precision)
    : view_(view),
      precision_(precision),
      perspective_(view.camera.projection == Projection::perspective),
      px_per_u_(view.width / (view.camera.window.right - view.camera.window.left)),
      px_per_v_(view.height / (view.camera.window.top - view.camera.window.bottom)),
      orthonormality_(largest_defect(view.camera)) {
    const Camera& c = view.camera;
    largest_u_ = std::max(std::abs(c.window.left), std::abs(c.window.right));
    largest_v_ = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    slant_u_ = perspective_ ? largest_u_ : std::abs(c.shear.x);
    slant_v_ = perspective_ ? largest_v_ : std::abs(c.shear.y);
    direction_abs_ = slant_u_ * glm::abs(c.right) + slant_v_ * glm::abs(c.up) + glm::abs(c.back);
    origin_abs_ = perspective_ ? glm::dvec3(0) : largest_u_ * glm::abs(c.right) + largest_v_ * glm::abs(c.up);
    if (const auto* raster = std::get_if<RasterPrecision>(&precision))
        background_eps_px_ = std::ldexp(raster->snap == Snap::nearest ? 0.5 : 1.0, -raster->subpixel_bits);
    else if (const auto* ray = std::get_if<RayPrecision>(&precision))
        set_aim(unit_of(ray->arithmetic));
    else
        set_aim(gamma(24, unit_roundoff_float64), std::get<PlaneRayPrecision>(precision).aim_offset_px);
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
    const Camera& c = view_.camera;
    const std::array axes{glm::abs(c.right), glm::abs(c.up), glm::abs(c.back)};
    const glm::dvec3 eye(c.eye_world), eye_abs = glm::abs(eye);
    TriangleExtent extent;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 p(p_world[size_t(i)]);
        extent.v_world[size_t(i)] = p - eye;
        extent.depth[size_t(i)] = -glm::dot(c.back, p - eye);
        const glm::dvec3 away_abs = glm::abs(p - eye) + origin_abs_, p_abs = glm::abs(p) + eye_abs;
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3& a = axes[size_t(axis)];
            extent.from_eye[axis] = std::max(extent.from_eye[axis], glm::dot(a, away_abs));
            extent.from_origin[axis] = std::max(extent.from_origin[axis], glm::dot(a, p_abs));
        }
    }
    extent.plane_size = plane_size_of(extent, p_world);
    return extent;
}

PlaneSize ViewBounds::plane_size_of(const TriangleExtent& extent, const CornersWorld& p_world) const {
    const glm::dvec3 e1 = glm::dvec3(p_world[1]) - glm::dvec3(p_world[0]);
    const glm::dvec3 e2 = glm::dvec3(p_world[2]) - glm::dvec3(p_world[0]);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const glm::dvec3 normal_abs = abs_cross(e1, e2) + abs_cross(e1, e2 - e1) + abs_cross(e2, e2 - e1);
    const Camera& c = view_.camera;
    const double from_corner = glm::dot(glm::abs(extent.v_world[0]) + origin_abs_, normal_abs);
    const double along_sight = glm::dot(direction_abs_, normal_abs);
    if (perspective_) return {std::abs(glm::dot(extent.v_world[0], normal)), from_corner, along_sight, 0};
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    const double origin_error =
        double_gammas[6] * glm::dot(glm::abs(glm::dvec3(c.eye_world)) + origin_abs_, normal_abs);
    return {std::abs(glm::dot(direction, normal)), along_sight, from_corner, origin_error};
}

TriangleBounds ViewBounds::of(const TriangleExtent& extent) const {
    return between_the_planes(
        std::visit([&](const auto& precision) { return bounds_by(extent, precision); }, precision_), extent);
}

TriangleBounds ViewBounds::of_depth(const TriangleExtent& extent) const {
    const auto* ray = std::get_if<RayPrecision>(&precision_);
    if (!ray) return of(extent);
    TriangleBounds bounds = hit_depth_by(extent, *ray);
    bounds.depth_factor += framing_by(*ray);
    return between_the_planes(bounds, extent);
}

TriangleBounds ViewBounds::between_the_planes(TriangleBounds bounds, const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    const auto [low, high] = std::minmax({extent.depth[0], extent.depth[1], extent.depth[2]});
    bounds.nearest = std::clamp(low, c.near_depth, c.far_depth);
    bounds.farthest = std::clamp(high, c.near_depth, c.far_depth);
    return bounds;
}

bool ViewBounds::keeps_to_corners() const {
    const auto* raster = std::get_if<RasterPrecision>(&precision_);
    return raster && raster->depth_buffer == DepthBuffer::camera_depth;
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const RasterPrecision& precision) const {
    const double u = unit_of(precision.transform);
    // float64: the fused matrix is built and applied in double: 3 (translation) + 3 + 3 (product of the two
    // matrices)
    // + 4 (matrix times point) roundings. float32: entries rounded once, then 4. Where the eye is subtracted
    // first, 1 more, of a smaller size.
    const bool from_eye = precision.origin == Origin::eye;
    const int roundings = (precision.transform == Arithmetic::float64 ? 13 : 5) + (from_eye ? 1 : 0);
    // a new corner: 4 roundings of its place on the edge, each at most twice the corners' size, then 5
    const bool in_volume = precision.clipping == Clipping::view_volume;
    const int clip_roundings = in_volume ? 13 * cut_count(extent) : 0;
    const double rounding =
        clip_roundings == 0 ? gammas_of(u)[std::size_t(roundings)] : gamma(roundings + clip_roundings, u);
    const double transform = rounding + orthonormality_;
    const glm::dvec3& size = from_eye ? extent.from_eye : extent.from_origin;
    // division, scale, offset; clipping's interpolation. In float64 the whole guard band costs 3e-11 px
    const bool is_coarse = precision.transform == Arithmetic::float32;
    const double limit = in_volume ? window_reach_px() : guard_band_px;
    const double viewport = gammas_of(u)[8] * (is_coarse ? reach_px(extent, limit) : limit);
    const double snap = background_eps_px_;
    const double lateral = transform * lateral_px(size);

    TriangleBounds bounds;
    bounds.eps_base_px = snap + viewport + (perspective_ ? 0 : lateral);
    bounds.eps_per_nearness = perspective_ ? lateral : 0;
    bounds.depth_eps_base_px = bounds.eps_base_px;
    bounds.depth_eps_per_nearness = bounds.eps_per_nearness;
    bounds.depth_factor = gamma(precision.depth_roundings, unit_roundoff_float32);
    bounds.depth_absolute = transform * size.z;
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + gammas_of(u)[8] * extent.largest_depth();
    if (precision.depth_buffer == DepthBuffer::camera_depth)
        bounds.depth_factor += gammas_of(unit_of(precision.interpolation))[8];
    else
        set_reversed_z(bounds, extent);
    return bounds;
}

void ViewBounds::set_reversed_z(TriangleBounds& bounds, const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    const double snap = background_eps_px_;
    const std::vector<WindowCorner> polygon = window_polygon(view_, extent);
    double highest = 0;  // nearness; only perspectives ask for it
    for (const WindowCorner& corner : polygon) highest = std::max(highest, corner.z / z_per_nearness(c));
    const double drift_base = bounds.eps_base_px - snap, drift_per = bounds.eps_per_nearness;
    const CornerShift shift{.snap_px = snap, .drift_px = drift_base + drift_per * highest};
    const auto [z_error, spread] = plane_equation_bounds(polygon, shift, view_);
    bounds.nearness_error = z_error / z_per_nearness(c);
    bounds.depth_eps_base_px = snap + spread * drift_base;
    bounds.depth_eps_per_nearness = spread * drift_per;
    if (perspective_) return;
    // z is made of far - depth
    bounds.depth_absolute += gamma(6, unit_roundoff_float32) * std::abs(c.far_depth);
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + bounds.nearness_error +
                                           gamma(8, unit_roundoff_float32) * extent.largest_depth();
}

double ViewBounds::window_reach_px() const {
    return 2 * std::max(px_per_u_ * largest_u_, px_per_v_ * largest_v_);
}

int ViewBounds::cut_count(const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    std::array<bool, 6> cuts{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.depth[i], w = perspective_ ? depth : 1;
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
        const double depth = extent.depth[i];
        if (!(depth >= c.near_depth)) return limit;
        const double x = glm::dot(c.right, extent.v_world[i]), y = glm::dot(c.up, extent.v_world[i]);
        const double u = perspective_ ? x / depth : x - c.shear.x * depth;
        const double v = perspective_ ? y / depth : y - c.shear.y * depth;
        reach =
            std::max({reach, px_per_u_ * (std::abs(u) + largest_u_), px_per_v_ * (std::abs(v) + largest_v_)});
    }
    return std::min(reach, limit);
}

double ViewBounds::edge_test_eps_px(const TriangleExtent& extent, int edge, double unit) const {
    const glm::dvec3& from = extent.v_world[size_t((edge + 1) % 3)];
    const glm::dvec3& to = extent.v_world[size_t((edge + 2) % 3)];
    const Camera& c = view_.camera;
    const double u_per_px = 1 / px_per_u_, v_per_px = 1 / px_per_v_;
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

/// Of the hit itself; on the way to a float32 more may be lost.
TriangleBounds ViewBounds::hit_depth_by(const TriangleExtent& extent, const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    // a corner is rounded once when the origin is subtracted
    const double corner = u * lateral_px(extent.from_eye);
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();
    TriangleBounds bounds;
    bounds.depth_eps_base_px = aim + (perspective_ ? 0 : corner);
    bounds.depth_eps_per_nearness = perspective_ ? corner : 0;

    // t = (v0 . n) / (d . n): 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and the
    // product
    const Gammas& gammas = gammas_of(u);
    const PlaneSize& size = extent.plane_size;
    const auto over_volume = [&](double sum_abs) {  // unlimited where the plane holds the origin of sight
        return size.volume > 0 ? gammas[8] * sum_abs / size.volume : unlimited;
    };
    const double volume_factor = over_volume(size.volume_abs);
    const double numerator_error = over_volume(size.numerator_abs);
    bounds.depth_factor = gammas[4] + aim_depth_relative_ + volume_factor;
    bounds.depth_absolute = u * extent.from_eye.z + aim_depth_absolute_;
    if (perspective_)
        bounds.plane_offset = numerator_error;
    else
        bounds.depth_absolute += numerator_error * (1 + BoundsOnPlane::compounded(volume_factor));
    return bounds;
}

/// Frames hold float32: a wider depth is rounded once more on its way there.
double ViewBounds::framing_by(const RayPrecision& precision) {
    return precision.arithmetic == Arithmetic::float64 ? unit_roundoff_float32 : 0;
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    TriangleBounds bounds = hit_depth_by(extent, precision);
    const double corner = u * lateral_px(extent.from_eye);
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();
    double edges = 0;
    for (int edge = 0; edge < 3; ++edge) edges = std::max(edges, edge_test_eps_px(extent, edge, u));
    // the robust test admits barycentrics down to -2u: a step of at most 2u (|v_i| + |q|)
    bounds.eps_base_px = aim + edges + (perspective_ ? 0 : 5 * corner);
    bounds.eps_per_nearness = perspective_ ? 5 * corner : 0;
    const auto slack = [&](double plane_depth) {
        const double share =
            BoundsOnPlane::compounded(u + bounds.depth_factor + bounds.plane_offset * plane_depth);
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
    const bool may_graze = extent.plane_size.volume <= 2 * precision.least_grazing_sine * area * reach;
    return error + (may_graze ? precision.least_grazing_sine * reach : 0);
}

TriangleBounds ViewBounds::bounds_by(const TriangleExtent& extent, const PlaneRayPrecision& precision) const {
    constexpr double u = unit_roundoff_float64;
    const double corner = u * lateral_px(extent.from_eye);
    const double inside = lateral_px(glm::dvec3(plane_test_error(extent, precision)));
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();

    TriangleBounds bounds;
    bounds.eps_base_px = aim + (perspective_ ? 0 : corner + inside);
    bounds.eps_per_nearness = perspective_ ? corner + inside : 0;
    bounds.depth_eps_base_px = aim + (perspective_ ? 0 : corner);
    bounds.depth_eps_per_nearness = perspective_ ? corner : 0;

    // where the ray meets the plane as for Pluecker rays, the normal's length taken out: 10 roundings in each
    // product; then -back . (origin + t d)
    const Camera& c = view_.camera;
    const PlaneSize& size = extent.plane_size;
    const auto over_volume = [&](double sum) {
        return size.volume > 0 ? gamma(10, u) * sum / size.volume : unlimited;
    };
    const double volume_factor = over_volume(size.volume_abs),
                 numerator_error = over_volume(size.numerator_abs);
    const double along = gamma(8, u) * glm::dot(glm::abs(c.back), direction_abs_) +
                         orthonormality_ * (1 + slant_u_ + slant_v_);
    const double hit_factor = gamma(8, u) + aim_depth_relative_ + volume_factor + along;
    bounds.depth_factor = hit_factor + precision.depth_relative;
    bounds.depth_absolute = u * extent.from_eye.z + aim_depth_absolute_;
    if (perspective_) {
        bounds.plane_offset = numerator_error;
    } else {
        bounds.depth_absolute += numerator_error * (1 + BoundsOnPlane::compounded(volume_factor)) +
                                 (gamma(8, u) * sum_abs(c.back) + orthonormality_) * ray_reach(extent);
    }
    const auto slack = [&](double plane_depth) {
        const double share = BoundsOnPlane::compounded(hit_factor + bounds.plane_offset * plane_depth);
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

DepthLaw BoundsOnPlane::depth_law() const {
    DepthLaw law{};
    law.least = least_;
    law.highest = highest_;
    law.base = depth_eps_px_.base;
    law.per = depth_eps_px_.per;
    law.most = depth_eps_px_.most;
    law.amplification = depth_eps_px_.amplification;
    law.depth_factor = depth_factor_;
    law.plane_offset = plane_offset_;
    law.absolute = depth_absolute_;
    law.nearness_error = nearness_error_;
    return law;
}

LocalBounds TriangleBounds::at(double nearness, double gradient) const {
    return BoundsOnPlane(*this, gradient).at(nearness);
}

BoundsOnPlane::BoundsOnPlane(const TriangleBounds& b, double gradient)
    : least_(b.farthest > 0 && std::isfinite(b.farthest) ? 1 / b.farthest : 0),
      highest_(b.nearest > 0 ? 1 / b.nearest : 0),
      eps_px_(displacement(b.eps_base_px, b.eps_per_nearness, gradient)),
      depth_eps_px_(displacement(b.depth_eps_base_px, b.depth_eps_per_nearness, gradient)),
      depth_factor_(b.depth_factor),
      plane_offset_(b.plane_offset),
      depth_relative_(compounded(b.depth_factor)),
      depth_absolute_(b.depth_absolute),
      nearness_error_(b.nearness_error) {}

BoundsOnPlane::Displacement BoundsOnPlane::displacement(double base, double per, double gradient) const {
    const double loop = per * gradient;
    return {base, per, base + per * highest_, loop < 1 ? 1 / (1 - loop) : unlimited};
}

}  // namespace zproof
