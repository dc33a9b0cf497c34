/// From a triangle's size and a renderer's precision to the law of its depth (docs/bounds.md). In double, or
/// four at a time.
#pragma once

#include "compare/bounds/depth_law.h"
#include "compare/bounds/triangle_size.h"
#include "frame/plane.h"

namespace zproof {

/// What a displaced point moves in the image.
struct ImageScale {
    double px_per_u, px_per_v;  ///< pixels per unit of the image plane
    double slant_u, slant_v;    ///< largest |d(u, v)/d depth| of a line of sight in the image

    /// Largest displacement in the image, px times depth, of errors of camera_abs along the camera's axes.
    template <class Number>
    Number lateral_px(const Vector3<Number>& camera_abs) const {
        return larger(px_per_u * (camera_abs.x + slant_u * camera_abs.z),
                      px_per_v * (camera_abs.y + slant_v * camera_abs.z));
    }
};

/// The terms of a triangle's depth, named as in docs/bounds.md: eps = base + per nearness.
template <class Number>
struct DepthTerms {
    Number eps_base_px, eps_per_nearness;
    Number factor, absolute;
    Number nearness_error, plane_offset;
};

/// 1 / (1 - sum) - 1: what factors and divisors whose relative errors add up to `sum` may come to (Higham
/// 2002, Lemma 3.1); unlimited from 1 up.
template <class Number>
Number compounded(const Number& sum) {
    const Number share = sum / (1.0 - sum);
    return sum < 1.0 ? share : everywhere<Number>(std::numeric_limits<double>::infinity());
}

/// A rasterizer's, of which nothing depends on the triangle but its size.
struct RasterTerms {
    ImageScale scale;
    Projection projection;
    double base_px;    ///< snap + viewport
    double transform;  ///< of the size
    double factor;     ///< of depth
    enum class Size { from_eye, from_origin } size;

    template <class Number>
    DepthTerms<Number> of(const TriangleSize<Number>& triangle) const {
        const Vector3<Number>& moved = size == Size::from_eye ? triangle.from_eye : triangle.from_origin;
        const Number lateral = transform * scale.lateral_px(moved), none{};
        const bool perspective = projection == Projection::perspective;
        return {.eps_base_px = base_px + (perspective ? none : lateral),
                .eps_per_nearness = perspective ? lateral : none,
                .factor = everywhere<Number>(factor),
                .absolute = transform * moved.z,
                .nearness_error = none,
                .plane_offset = none};
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

    template <class Number>
    DepthTerms<Number> of(const TriangleSize<Number>& t) const {
        // a corner is rounded once when the origin is subtracted
        const Number corner = unit * scale.lateral_px(t.from_eye), none{};
        const Number largest_depth =
            larger(larger(absolute(t.depth[0]), absolute(t.depth[1])), absolute(t.depth[2]));
        const Number aim = aim_px + aim_px_per_depth * largest_depth;
        // t = (v0 . n) / (d . n): 8 roundings in each product (3 of the dot, 5 of n), 4 of the reciprocal and
        // the product
        const auto over_volume = [&](const Number& sum_abs) {  // unlimited where the plane holds the origin
            const Number share = of_products * sum_abs / t.plane.volume;
            return t.plane.volume > 0.0 ? share : everywhere<Number>(std::numeric_limits<double>::infinity());
        };
        const Number volume_factor = over_volume(t.plane.volume_abs);
        const Number numerator_error = over_volume(t.plane.numerator_abs);
        const bool perspective = projection == Projection::perspective;
        const Number rounded_aim = unit * t.from_eye.z + aim_absolute;
        const Number of_plane = numerator_error * (1.0 + compounded(volume_factor));
        return {.eps_base_px = perspective ? aim : aim + corner,
                .eps_per_nearness = perspective ? corner : none,
                .factor = factor + volume_factor,
                .absolute = perspective ? rounded_aim : rounded_aim + of_plane,
                .nearness_error = none,
                .plane_offset = perspective ? numerator_error : none};
    }
};

/// eps = base + per (nearness + gradient eps), solved for eps; never beyond the nearest corner's.
template <class Number>
struct Displacement {
    Displacement(const Number& base_px, const Number& per_nearness, const Number& gradient,
                 const Number& highest)
        : base(base_px), per(per_nearness), most(base + per * highest) {
        const Number loop = per * gradient, enlarged = 1.0 / (1.0 - loop);
        amplification = loop < 1.0 ? enlarged : everywhere<Number>(std::numeric_limits<double>::infinity());
    }

    Number at(const Number& nearness) const {
        return per == 0 ? base : smaller(most, (base + per * nearness) * amplification);
    }

    Number base, per, most, amplification;
};

/// The nearness of the farthest and the nearest corner.
template <class Number>
struct CornerNearness {
    CornerNearness(const Number& nearest, const Number& farthest) {
        const Number of_farthest = 1.0 / farthest, of_nearest = 1.0 / nearest, none{};
        least = farthest > 0.0 ? of_farthest : none;  // none at infinity, too
        highest = nearest > 0.0 ? of_nearest : none;
    }

    Number least, highest;
};

/// The error of a nearness computed in double, anywhere in the image.
template <class Number>
Number own_error_of(const PlaneSizeOf<Number>& plane, const Affine<Number>& nearness,
                    const Resolution& size) {
    return PlaneErrorOf<Number>(plane).at(absolute(nearness.c) + absolute(nearness.a) * double(size.width) +
                                          absolute(nearness.b) * double(size.height));
}

/// What renderers of one view share about a triangle's depth.
template <class Number>
struct PlaneOfLaw {
    Affine<Number> nearness;  ///< of pixel indices
    Number gradient, own_error;
    Number nearest, farthest;  ///< camera depths of the corners, clamped to near and far
};

/// Barycentrics of a snapped triangle stay between its corners' depths; a ray and a plane equation meet the
/// plane.
enum class KeepsToCorners { no, yes };

/// What both TriangleDepth::at and certainly_holds say, over the whole image; as law_of_nothing where that
/// takes more than a law.
template <class Number>
DepthLawOf<Number> law_of(const PlaneOfLaw<Number>& plane, const DepthTerms<Number>& terms,
                          KeepsToCorners keeps) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const CornerNearness<Number> corners(plane.nearest, plane.farthest);
    const Displacement<Number> eps(terms.eps_base_px, terms.eps_per_nearness, plane.gradient,
                                   corners.highest);
    const auto is_known = (plane.own_error < infinite) & (terms.absolute + terms.nearness_error < infinite);
    const Number relative = compounded(terms.factor);
    const bool is_kept = keeps == KeepsToCorners::yes;
    return {.nearness_per_x = plane.nearness.a,
            .nearness_per_y = plane.nearness.b,
            .nearness_offset = plane.nearness.c,
            .gradient = plane.gradient,
            .own_error = plane.own_error,
            .least = corners.least,
            .highest = corners.highest,
            .base = eps.base,
            .per = eps.per,
            .most = eps.most,
            .amplification = eps.amplification,
            .depth_factor = is_known ? terms.factor : everywhere<Number>(law_of_nothing.depth_factor),
            .plane_offset = terms.plane_offset,
            .absolute = terms.absolute,
            .nearness_error = terms.nearness_error,
            .relative = is_known ? relative : everywhere<Number>(law_of_nothing.relative),
            .nearest = is_kept ? plane.nearest : everywhere<Number>(-infinite),
            .farthest = is_kept ? plane.farthest : everywhere<Number>(infinite)};
}

}  // namespace zproof
