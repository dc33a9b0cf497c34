#include "compare/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double guard_band_px = 32768;  ///< clipped vertices lie within it (D3D11.3 15.16: 16.8 coordinates)

double unit_of(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::float32 ? unit_roundoff_float32 : unit_roundoff_float64;
}

glm::dvec3 abs_cross(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 p = glm::abs(a), q = glm::abs(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
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

double PlaneSize::nearness_error(double largest_nearness) const {
    const double u = gamma(16, unit_roundoff_float64), condition = volume_abs / volume;
    return u * condition < 0.5
               ? 2 * u * (numerator_abs / volume + largest_nearness * condition) + 2 * origin_error / volume
               : unlimited;
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
    const double u_abs = std::max(std::abs(c.window.left), std::abs(c.window.right));
    const double v_abs = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    slant_u_ = perspective_ ? u_abs : std::abs(c.shear.x);
    slant_v_ = perspective_ ? v_abs : std::abs(c.shear.y);
    direction_abs_ = slant_u_ * glm::abs(c.right) + slant_v_ * glm::abs(c.up) + glm::abs(c.back);
    origin_abs_ = perspective_ ? glm::dvec3(0) : u_abs * glm::abs(c.right) + v_abs * glm::abs(c.up);
    if (const auto* raster = std::get_if<RasterPrecision>(&precision))
        background_eps_px_ = std::ldexp(raster->snap == Snap::nearest ? 0.5 : 1.0, -raster->subpixel_bits);
    else
        set_aim(unit_of(std::get<RayPrecision>(precision).arithmetic));
}

void ViewBounds::set_aim(double unit) {
    const Camera& c = view_.camera;
    const std::array axes{c.right, c.up, c.back};
    const glm::dvec3 origin_world = glm::abs(glm::dvec3(c.eye_world)) + origin_abs_;
    glm::dvec3 direction_error, origin_error;  // per camera axis
    for (int i = 0; i < 3; ++i) {
        direction_error[i] = unit * glm::dot(glm::abs(axes[size_t(i)]), direction_abs_);
        origin_error[i] = perspective_ ? 0 : unit * glm::dot(glm::abs(axes[size_t(i)]), origin_world);
    }
    aim_px_ = lateral_px(perspective_ ? direction_error : origin_error);
    aim_px_per_depth_ = perspective_ ? 0 : lateral_px(direction_error);
    aim_depth_relative_ = direction_error.z;
    aim_depth_absolute_ = origin_error.z;
    background_eps_px_ = aim_px_;
}

TriangleExtent ViewBounds::extent_of(const CornersWorld& p_world) const {
    const Camera& c = view_.camera;
    const std::array axes{c.right, c.up, c.back};
    const glm::dvec3 eye(c.eye_world);
    TriangleExtent extent;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 p(p_world[size_t(i)]);
        extent.v_world[size_t(i)] = p - eye;
        extent.depth[size_t(i)] = -glm::dot(c.back, p - eye);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 a = glm::abs(axes[size_t(axis)]);
            extent.from_eye[axis] =
                std::max(extent.from_eye[axis], glm::dot(a, glm::abs(p - eye) + origin_abs_));
            extent.from_origin[axis] =
                std::max(extent.from_origin[axis], glm::dot(a, glm::abs(p) + glm::abs(eye)));
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
    const double origin_error = gamma(6, unit_roundoff_float64) *
                                glm::dot(glm::abs(glm::dvec3(c.eye_world)) + origin_abs_, normal_abs);
    return {std::abs(glm::dot(direction, normal)), along_sight, from_corner, origin_error};
}

TriangleBounds ViewBounds::of(const TriangleExtent& extent) const {
    if (const auto* raster = std::get_if<RasterPrecision>(&precision_))
        return with_depths(raster_bounds(extent, *raster), extent);
    const auto& ray = std::get<RayPrecision>(precision_);
    return with_depths(with_ray_coverage(ray_depth_bounds(extent, ray), extent, ray), extent);
}

TriangleBounds ViewBounds::for_depth(const TriangleExtent& extent) const {
    if (const auto* raster = std::get_if<RasterPrecision>(&precision_))
        return with_depths(raster_bounds(extent, *raster), extent);
    return with_depths(ray_depth_bounds(extent, std::get<RayPrecision>(precision_)), extent);
}

TriangleBounds ViewBounds::with_depths(TriangleBounds bounds, const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    const auto [low, high] = std::minmax({extent.depth[0], extent.depth[1], extent.depth[2]});
    bounds.nearest = std::clamp(low, c.near_depth, c.far_depth);
    bounds.farthest = std::clamp(high, c.near_depth, c.far_depth);
    return bounds;
}

TriangleBounds ViewBounds::raster_bounds(const TriangleExtent& extent,
                                         const RasterPrecision& precision) const {
    const double u = unit_of(precision.transform);
    // float64: the fused matrix is built and applied in double: 3 (translation) + 3 + 3 (product of the two
    // matrices)
    // + 4 (matrix times point) roundings. float32: entries rounded once, then 4.
    const double transform =
        (precision.transform == Arithmetic::float64 ? gamma(13, u) : gamma(5, u)) + orthonormality_;
    // division, scale, offset; clipping's interpolation. In float64 the whole guard band costs 3e-11 px
    const bool is_coarse = precision.transform == Arithmetic::float32;
    const double viewport = gamma(8, u) * (is_coarse ? reach_px(extent) : guard_band_px);
    const double snap = background_eps_px_;
    const double lateral = transform * lateral_px(extent.from_origin);

    TriangleBounds bounds;
    bounds.eps_base_px = snap + viewport + (perspective_ ? 0 : lateral);
    bounds.eps_per_nearness = perspective_ ? lateral : 0;
    bounds.depth_eps_base_px = bounds.eps_base_px;
    bounds.depth_eps_per_nearness = bounds.eps_per_nearness;
    bounds.depth_factor =
        gamma(precision.depth_roundings, unit_roundoff_float32) + gamma(8, unit_of(precision.interpolation));
    bounds.depth_absolute = transform * extent.from_origin.z;
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + gamma(8, u) * extent.largest_depth();
    return bounds;
}

double ViewBounds::reach_px(const TriangleExtent& extent) const {
    const Camera& c = view_.camera;
    const Window& w = c.window;
    const double u_window = std::max(std::abs(w.left), std::abs(w.right));
    const double v_window = std::max(std::abs(w.bottom), std::abs(w.top));
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.depth[i];
        if (!(depth >= c.near_depth)) return guard_band_px;
        const double x = glm::dot(c.right, extent.v_world[i]), y = glm::dot(c.up, extent.v_world[i]);
        const double u = perspective_ ? x / depth : x - c.shear.x * depth;
        const double v = perspective_ ? y / depth : y - c.shear.y * depth;
        reach = std::max({reach, px_per_u_ * (std::abs(u) + u_window), px_per_v_ * (std::abs(v) + v_window)});
    }
    return std::min(reach, guard_band_px);
}

double ViewBounds::edge_test_eps_px(const TriangleExtent& extent, int edge, double unit) const {
    const glm::dvec3& from = extent.v_world[size_t((edge + 1) % 3)];
    const glm::dvec3& to = extent.v_world[size_t((edge + 2) % 3)];
    const Camera& c = view_.camera;
    const double u_per_px = 1 / px_per_u_, v_per_px = 1 / px_per_v_;
    const glm::dvec3 difference = to - from, sum = to + from;
    const glm::dvec3 sum_abs = glm::abs(sum) + 2.0 * origin_abs_;
    const double error = gamma(7, unit) * glm::dot(abs_cross(difference, sum_abs), direction_abs_);
    // |d/dx| + |d/dy| of (difference x sum) . direction
    const glm::dvec3 toward_x = u_per_px * c.right, toward_y = v_per_px * c.up;
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    const glm::dvec3 moment =
        perspective_ ? glm::cross(difference, sum) : 2.0 * glm::cross(direction, difference);
    const double gradient = std::abs(glm::dot(moment, toward_x)) + std::abs(glm::dot(moment, toward_y));
    return gradient > 0 ? error / gradient : 0;  // an edge without extent in the image bounds no area
}

TriangleBounds ViewBounds::ray_depth_bounds(const TriangleExtent& extent,
                                            const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    // a corner is rounded once when the origin is subtracted
    const double corner = u * lateral_px(extent.from_eye);
    const double aim = aim_px_ + aim_px_per_depth_ * extent.largest_depth();
    TriangleBounds bounds;
    bounds.depth_eps_base_px = aim + (perspective_ ? 0 : corner);
    bounds.depth_eps_per_nearness = perspective_ ? corner : 0;

    // t = (v0 . n) / (d . n): 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and the
    // product
    const PlaneSize& size = extent.plane_size;
    const auto over_volume = [&](double sum_abs) {  // unlimited where the plane holds the origin of sight
        return size.volume > 0 ? gamma(8, u) * sum_abs / size.volume : unlimited;
    };
    const double volume_factor = over_volume(size.volume_abs);
    const double numerator_error = over_volume(size.numerator_abs);
    bounds.depth_factor = gamma(4, u) + aim_depth_relative_ + volume_factor;
    bounds.depth_absolute = u * extent.from_eye.z + aim_depth_absolute_;
    if (perspective_)
        bounds.plane_offset = numerator_error;
    else
        bounds.depth_absolute += numerator_error * (1 + BoundsOnPlane::compounded(volume_factor));
    return bounds;
}

TriangleBounds ViewBounds::with_ray_coverage(TriangleBounds bounds, const TriangleExtent& extent,
                                             const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
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
    return bounds;
}

DepthRow BoundsOnPlane::depth_row() const {
    DepthRow row{};
    row.least = least_;
    row.highest = highest_;
    row.base = depth_eps_px_.base;
    row.per = depth_eps_px_.per;
    row.most = depth_eps_px_.most;
    row.amplification = depth_eps_px_.amplification;
    row.depth_factor = depth_factor_;
    row.plane_offset = plane_offset_;
    row.absolute = depth_absolute_;
    return row;
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
      depth_absolute_(b.depth_absolute) {}

BoundsOnPlane::Displacement BoundsOnPlane::displacement(double base, double per, double gradient) const {
    const double loop = per * gradient;
    return {base, per, base + per * highest_, loop < 1 ? 1 / (1 - loop) : unlimited};
}

}  // namespace zproof
