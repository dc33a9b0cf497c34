/// Computes the terms of a triangle's depth from its size and a renderer's precision (docs/bounds.md).
/// Written without branches, so that the compiler works on several triangles at a time.
#pragma once

#include "compare/bounds/triangle_size.h"

namespace zproof {

/// A bound where nothing is known.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// What a displaced point moves in the image.
struct ImageScale {
    double px_per_u, px_per_v;  ///< pixels per unit of the image plane
    double slant_u, slant_v;    ///< largest |d(u, v)/d depth| of a view ray in the image

    /// Largest displacement in the image, px times depth, of errors of camera_abs along the camera's axes.
    double lateral_px(const Vector3<double>& camera_abs) const {
        return std::max(px_per_u * (camera_abs.x + slant_u * camera_abs.z),
                        px_per_v * (camera_abs.y + slant_v * camera_abs.z));
    }
};

/// The terms of a triangle's depth, named as in docs/bounds.md: eps = base + per inverse depth.
struct DepthTerms {
    double eps_base_px, eps_per_inverse_depth;
    double factor, absolute;
    double inverse_depth_error, plane_offset;
    double share = 0;  ///< relative error of depth beside its factors; not compounded
    double inverse_depth_bias = 0;
};

/// 1 / (1 - sum) - 1: what factors and divisors whose relative errors add up to `sum` may come to (Higham
/// 2002, Lemma 3.1); unlimited from 1 up.
inline double compounded(double sum) {
    const double share = sum / (1 - sum);
    return sum < 1 ? share : unlimited;
}

/// A rasterizer's, of which nothing depends on the triangle but its size.
struct RasterTerms {
    ImageScale scale;
    Projection projection;
    double base_px;    ///< snap + viewport
    double transform;  ///< of the size
    double factor;     ///< of depth
    enum class Size { from_eye, from_origin } size;

    DepthTerms of(const TriangleSize& triangle) const {
        const Vector3<double>& moved = size == Size::from_eye ? triangle.from_eye : triangle.from_origin;
        const double lateral = transform * scale.lateral_px(moved);
        const bool perspective = projection == Projection::perspective;
        return {.eps_base_px = base_px + (perspective ? 0 : lateral),
                .eps_per_inverse_depth = perspective ? lateral : 0,
                .factor = factor,
                .absolute = transform * moved.z,
                .inverse_depth_error = 0,
                .plane_offset = 0};
    }
};

/// A caster of Pluecker rays.
struct RayTerms {
    ImageScale scale;
    Projection projection;
    double unit;         ///< u, a corner's rounding
    double of_products;  ///< gamma(8)
    double factor;       ///< of depth: gamma(4) + aim
    double aim_px, aim_px_per_depth, aim_absolute;
    double start;  ///< how far behind the eye rays start

    DepthTerms of(const TriangleSize& t) const {
        // a corner is rounded once when the origin is subtracted
        const double corner = unit * scale.lateral_px(t.from_eye);
        const double largest_depth =
            std::max(std::max(std::abs(t.depth[0]), std::abs(t.depth[1])), std::abs(t.depth[2]));
        const double aim = aim_px + aim_px_per_depth * (largest_depth + start);
        // t = (v0 . n) / (d . n): 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and
        // the product
        // unlimited where the plane holds the origin, but for zeros that no rounding can change
        const double where_edge_on = t.plane.volume_abs > 0 ? unlimited : 0;
        const auto over_volume = [&](double sum_abs) {
            const double share = of_products * sum_abs / t.plane.volume;
            return t.plane.volume > 0 ? share : where_edge_on;
        };
        const double volume_factor = over_volume(t.plane.volume_abs);
        const double numerator_error = over_volume(t.plane.numerator_abs);
        const bool perspective = projection == Projection::perspective;
        const double rounded_aim = unit * t.from_eye.z + aim_absolute;
        // what is off by a share is the distance from the start; adding that rounds once more
        const double of_start = start > 0 ? start * compounded(factor + volume_factor + unit) : 0;
        const double of_plane = numerator_error * (1 + compounded(volume_factor)) + of_start;
        return {.eps_base_px = perspective ? aim : aim + corner,
                .eps_per_inverse_depth = perspective ? corner : 0,
                .factor = factor + volume_factor + (start > 0 ? unit : 0),
                .absolute = perspective ? rounded_aim : rounded_aim + of_plane,
                .inverse_depth_error = 0,
                .plane_offset = perspective ? numerator_error : 0};
    }
};

/// eps = base + per (inverse depth + gradient eps), solved for eps; never beyond the nearest corner's.
struct Displacement {
    Displacement() = default;
    Displacement(double base_px, double per_inverse_depth, double gradient, double highest)
        : base(base_px), per(per_inverse_depth), most(base + per * highest) {
        const double loop = per * gradient, enlarged = 1 / (1 - loop);
        amplification = loop < 1 ? enlarged : unlimited;
    }

    double at(double inverse_depth) const {
        const double reach = (base + per * inverse_depth) * amplification, kept = reach < most ? reach : most;
        return per == 0 ? base : kept;
    }

    double base = 0, per = 0, most = 0, amplification = 1;
};

/// The inverse depth of the farthest and the nearest corner.
struct CornerInverseDepth {
    CornerInverseDepth() = default;
    CornerInverseDepth(double nearest_depth, double farthest_depth) {
        const double of_farthest = 1 / farthest_depth, of_nearest = 1 / nearest_depth;
        least = farthest_depth > 0 ? of_farthest : 0;  // 0 at infinity, too
        highest = nearest_depth > 0 ? of_nearest : 0;
    }

    double least = 0, highest = 0;
};

}  // namespace zproof
