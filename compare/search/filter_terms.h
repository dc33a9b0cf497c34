/// What a triangle's filter says, and how far rounding may put it off (docs/truth.md, "How it is decided").
/// In double, or four at a time.
#pragma once

#include <array>

#include "compare/bounds/triangle_size.h"

namespace zproof {

/// Half-planes and nearness over the whole image, as TriangleFilter has them.
template <class Number>
struct FilterTerms {
    std::array<Affine<Number>, 3> edge;
    std::array<Number, 3> edge_error;
    Affine<Number> nearness;
    Number nearness_error;
    decltype(Number{} < Number{}) is_trusted;  ///< or may it be edge-on?
};

/// Makes those of one view's triangles.
template <class Number>
struct FilterLens {
    Sight<Number> sight;  ///< of pixel (0, 0)
    Number width, height;
    Number origin_size, direction_size;  ///< largest sums of absolute terms in the image

    using Edges = std::array<Affine<Number>, 3>;
    bool is_perspective() const { return sight.projection == Projection::perspective; }

    /// By the plane's own error. Of a perspective `edges` are those that image_of() gives, if it gives any.
    FilterTerms<Number> terms_of(const Corners<Number>& p, const PlaneErrorOf<Number>& plane_error,
                                 const Edges& edges) const {
        // from sides in world space, so that its rounding is relative to the sides, not to the distance
        const Vector3<Number> normal = cross(p[1] - p[0], p[2] - p[0]);
        return with_errors(is_perspective() ? in_perspective(p, normal, edges) : in_parallel(p, normal),
                           plane_error);
    }
    /// Of a perspective; as image_of() gives them, of triangles that are trusted.
    Edges edges_of(const Corners<Number>& p) const {
        const Vector3<Number> v0 = p[0] - sight.origin, v1 = p[1] - sight.origin, v2 = p[2] - sight.origin;
        return oriented({detail::perspective_functional(sight, cross(v1, v2)),
                         detail::perspective_functional(sight, cross(v2, v0)),
                         detail::perspective_functional(sight, cross(v0, v1))},
                        dot(v0, cross(v1 - v0, v2 - v0)));
    }

  private:
    static Number size_of(const Vector3<Number>& v) { return absolute(v.x) + absolute(v.y) + absolute(v.z); }
    static Edges oriented(const Edges& edges, const Number& facing) {
        const Number sign = facing < 0.0 ? everywhere<Number>(-1) : everywhere<Number>(1);
        return {sign * edges[0], sign * edges[1], sign * edges[2]};
    }

    /// Without errors.
    struct Functionals {
        Edges edge;
        Affine<Number> nearness;
        Number facing;  ///< the divisor of nearness
        std::array<Number, 3>
            corner_sizes;  ///< as seen from the origin of sight, every term in absolute value
    };
    Functionals in_perspective(const Corners<Number>& p, const Vector3<Number>& normal,
                               const Edges& edges) const {
        const Vector3<Number> v0 = p[0] - sight.origin;
        const Number facing = dot(v0, normal);
        return {edges,
                (1.0 / facing) * detail::perspective_functional(sight, normal),
                facing,
                {size_of(v0), size_of(p[1] - sight.origin), size_of(p[2] - sight.origin)}};
    }
    Functionals in_parallel(const Corners<Number>& p, const Vector3<Number>& normal) const {
        const Vector3<Number> v0 = p[0] - sight.origin, v1 = p[1] - sight.origin, v2 = p[2] - sight.origin;
        const Number facing = dot(normal, sight.direction);
        const Affine<Number> scaled{-dot(normal, sight.step_x), -dot(normal, sight.step_y), dot(normal, v0)};
        return {oriented({detail::parallel_edge(sight, v1, v2), detail::parallel_edge(sight, v2, v0),
                          detail::parallel_edge(sight, v0, v1)},
                         facing),
                (-1.0 / facing) * scaled,
                facing,
                {size_of(p[0]) + origin_size, size_of(p[1]) + origin_size, size_of(p[2]) + origin_size}};
    }

    FilterTerms<Number> with_errors(const Functionals& of, const PlaneErrorOf<Number>& plane_error) const {
        // each of five terms is below V V' D and has at most 40 roundings; once for us, once for image_of
        constexpr double share = 2 * 5 * gamma(40, unit_roundoff_float64);
        const auto& [v0, v1, v2] = of.corner_sizes;
        const Number d = direction_size, most = larger(larger(v0, v1), v2), rounding = share * most * most;
        const Affine<Number>& n = of.nearness;
        const Number nearness_error =
            2.0 * plane_error.at(absolute(n.c) + absolute(n.a) * width + absolute(n.b) * height);
        return {of.edge,
                {share * v1 * v2 * d, share * v2 * v0 * d, share * v0 * v1 * d},
                n,
                nearness_error,
                (nearness_error < std::numeric_limits<double>::infinity()) &&
                    (absolute(of.facing) > rounding * (is_perspective() ? most : d))};
    }
};

}  // namespace zproof
