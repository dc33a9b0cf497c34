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

/// A triangle's size as the error analysis sees it: per camera axis, sums of absolute products.
struct ViewBounds::Extent {
    std::array<glm::dvec3, 3> v_world;  ///< corner - eye
    std::array<double, 3> depth;
    glm::dvec3 from_eye{0};     ///< per camera axis: max over corners of sum |axis_j| |p_j - eye_j|
    glm::dvec3 from_origin{0};  ///< per camera axis: max over corners of sum |axis_j| (|p_j| + |eye_j|)

    /// Largest in-image displacement, px times depth, of an error of 1 relative to `camera_abs` on every
    /// axis.
    static double lateral_px(const ViewBounds& b, const glm::dvec3& camera_abs) {
        return std::max(b.px_per_u_ * (camera_abs.x + b.slant_u_ * camera_abs.z),
                        b.px_per_v_ * (camera_abs.y + b.slant_v_ * camera_abs.z));
    }
};

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
    background_eps_px_ = 0;
    if (const auto* raster = std::get_if<RasterPrecision>(&precision))
        background_eps_px_ = std::ldexp(raster->snap == Snap::nearest ? 0.5 : 1.0, -raster->subpixel_bits);
}

ViewBounds::Extent ViewBounds::extent_of(const CornersWorld& p_world) const {
    const Camera& c = view_.camera;
    const std::array axes{c.right, c.up, c.back};
    const glm::dvec3 eye(c.eye_world);
    Extent extent;
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
    return extent;
}

PlaneSize ViewBounds::plane_size_of(const Extent& extent, const CornersWorld& p_world) const {
    const glm::dvec3 e1 = glm::dvec3(p_world[1]) - glm::dvec3(p_world[0]);
    const glm::dvec3 e2 = glm::dvec3(p_world[2]) - glm::dvec3(p_world[0]);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const glm::dvec3 normal_abs = abs_cross(e1, e2) + abs_cross(e1, e2 - e1) + abs_cross(e2, e2 - e1);
    const Camera& c = view_.camera;
    const double from_corner = glm::dot(glm::abs(extent.v_world[0]) + origin_abs_, normal_abs);
    const double along_sight = glm::dot(direction_abs_, normal_abs);
    if (perspective_) return {std::abs(glm::dot(extent.v_world[0], normal)), from_corner, along_sight};
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    return {std::abs(glm::dot(direction, normal)), along_sight, from_corner};
}

TriangleBounds ViewBounds::of(const CornersWorld& p_world) const {
    const Extent extent = extent_of(p_world);
    const PlaneSize size = plane_size_of(extent, p_world);
    TriangleBounds bounds = std::holds_alternative<RasterPrecision>(precision_)
                                ? raster_bounds(extent, std::get<RasterPrecision>(precision_))
                                : ray_bounds(extent, size, std::get<RayPrecision>(precision_));
    bounds.plane_size = size;
    const Camera& c = view_.camera;
    const auto [low, high] = std::minmax({extent.depth[0], extent.depth[1], extent.depth[2]});
    bounds.nearest = std::clamp(low, c.near_depth, c.far_depth);
    bounds.farthest = std::clamp(high, c.near_depth, c.far_depth);
    return bounds;
}

TriangleBounds ViewBounds::raster_bounds(const Extent& extent, const RasterPrecision& precision) const {
    const double u = unit_of(precision.transform);
    // float64: the fused matrix is built and applied in double: 3 (translation) + 3 + 3 (product of the two
    // matrices)
    // + 4 (matrix times point) roundings. float32: entries rounded once, then 4.
    const double transform =
        (precision.transform == Arithmetic::float64 ? gamma(13, u) : gamma(5, u)) + orthonormality_;
    const double viewport = gamma(8, u) * guard_band_px;  // division, scale, offset; clipping's interpolation
    const double snap = background_eps_px_;
    const double lateral = transform * Extent::lateral_px(*this, extent.from_origin);

    TriangleBounds bounds;
    bounds.eps_base_px = snap + viewport + (perspective_ ? 0 : lateral);
    bounds.eps_per_nearness = perspective_ ? lateral : 0;
    bounds.depth_eps_base_px = bounds.eps_base_px;
    bounds.depth_eps_per_nearness = bounds.eps_per_nearness;
    bounds.depth_relative =
        gamma(precision.depth_roundings, unit_roundoff_float32) + gamma(8, unit_of(precision.interpolation));
    bounds.depth_absolute = transform * extent.from_origin.z;
    const double span =
        std::max({std::abs(extent.depth[0]), std::abs(extent.depth[1]), std::abs(extent.depth[2])});
    bounds.near_slack = bounds.far_slack = bounds.depth_absolute + gamma(8, u) * span;
    return bounds;
}

double ViewBounds::edge_test_eps_px(const Extent& extent, int edge, double unit) const {
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

TriangleBounds ViewBounds::ray_bounds(const Extent& extent, const PlaneSize& size,
                                      const RayPrecision& precision) const {
    const double u = unit_of(precision.arithmetic);
    const Camera& c = view_.camera;
    const std::array axes{c.right, c.up, c.back};
    glm::dvec3 direction_error, origin_error;  // per camera axis
    const glm::dvec3 origin_world = glm::abs(glm::dvec3(c.eye_world)) + origin_abs_;
    for (int i = 0; i < 3; ++i) {
        direction_error[i] = u * glm::dot(glm::abs(axes[size_t(i)]), direction_abs_);
        origin_error[i] = perspective_ ? 0 : u * glm::dot(glm::abs(axes[size_t(i)]), origin_world);
    }
    const double span =
        std::max({std::abs(extent.depth[0]), std::abs(extent.depth[1]), std::abs(extent.depth[2])});
    // a corner is rounded once when the origin is subtracted
    const double corner = u * Extent::lateral_px(*this, extent.from_eye);
    const double aim = Extent::lateral_px(*this, direction_error) * (perspective_ ? 1 : span) +
                       Extent::lateral_px(*this, origin_error);
    double edges = 0;
    for (int edge = 0; edge < 3; ++edge) edges = std::max(edges, edge_test_eps_px(extent, edge, u));

    TriangleBounds bounds;
    bounds.depth_eps_base_px = aim + (perspective_ ? 0 : corner);
    bounds.depth_eps_per_nearness = perspective_ ? corner : 0;
    // the robust test admits barycentrics down to -2u: a step of at most 2u (|v_i| + |q|)
    bounds.eps_base_px = aim + edges + (perspective_ ? 0 : 5 * corner);
    bounds.eps_per_nearness = perspective_ ? 5 * corner : 0;

    // t = (v0 . n) / (d . n): 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and the
    // product
    // where the plane holds the origin of sight, nothing bounds it
    const auto over_volume = [&](double sum_abs) {
        return size.volume > 0 ? gamma(8, u) * sum_abs / size.volume
                               : std::numeric_limits<double>::infinity();
    };
    bounds.depth_relative = gamma(4, u) + direction_error.z + over_volume(size.volume_abs);
    bounds.depth_absolute = u * extent.from_eye.z + origin_error.z;
    (perspective_ ? bounds.plane_offset : bounds.depth_absolute) += over_volume(size.numerator_abs);
    bounds.near_slack = c.near_depth * (u + bounds.depth_relative) + bounds.depth_absolute;
    bounds.far_slack = std::isfinite(c.far_depth)
                           ? c.far_depth * (u + bounds.depth_relative + bounds.plane_offset * c.far_depth) +
                                 bounds.depth_absolute
                           : 0;
    return bounds;
}

LocalBounds TriangleBounds::at(double nearness, double gradient) const {
    // perspective: eps = base + per (nearness + gradient eps), solved for eps; never beyond the nearest
    // corner's
    const double highest = nearest > 0 ? 1 / nearest : 0;
    const double here =
        std::clamp(nearness, farthest > 0 && std::isfinite(farthest) ? 1 / farthest : 0, highest);
    const auto solve = [&](double base, double per) {
        if (per == 0) return base;
        const double loop = per * gradient;
        const double most = base + per * highest;
        return loop < 1 ? std::min(most, (base + per * here) / (1 - loop)) : most;
    };
    return {.eps_px = solve(eps_base_px, eps_per_nearness),
            .depth_eps_px = solve(depth_eps_base_px, depth_eps_per_nearness),
            .depth_relative = depth_relative + (plane_offset > 0 ? plane_offset / std::max(here, 1e-300) : 0),
            .depth_absolute = depth_absolute};
}

}  // namespace zproof
