/// A triangle as seen around one pixel: half-planes and an inverse depth functional (homogeneous
/// rasterization, Olano and Greer 1997; docs/truth.md).
#pragma once

#include <array>
#include <optional>

#include "compare/bounds/view_ray.h"
#include "math/affine.h"
#include "math/sign.h"

namespace zproof {

template <class Number>
using Corners = std::array<Vector3<Number>, 3>;

/// All functionals take the offset from the pixel's centre in px.
template <class Number>
struct TriangleImage {
    std::array<Affine<Number>, 3> edge;  ///< >= 0 inside; edge i is opposite corner i
    /// Larger is nearer: 1/depth for perspective, -depth for parallel projections.
    Affine<Number> inverse_depth;
};

namespace detail {

template <class Number>
Affine<Number> perspective_functional(const ViewRay<Number>& ray, const Vector3<Number>& normal) {
    return {dot(normal, ray.step_x), dot(normal, ray.step_y), dot(normal, ray.direction)};
}

/// The edge from r1 to r2 (relative to the origin of the centre's view ray), for a constant direction d:
/// ((r1 - e) x (r2 - e)) . d with e = x step_x + y step_y.
template <class Number>
Affine<Number> parallel_edge(const ViewRay<Number>& ray, const Vector3<Number>& r1,
                             const Vector3<Number>& r2) {
    const Vector3<Number> side = cross(r2 - r1, ray.direction);
    return {-dot(side, ray.step_x), -dot(side, ray.step_y), dot(cross(r1, r2), ray.direction)};
}

/// The line through two points relative to the view ray's origin.
template <class Number>
Affine<Number> edge_between(const ViewRay<Number>& ray, const Vector3<Number>& v1,
                            const Vector3<Number>& v2) {
    if (ray.projection == Projection::parallel) return parallel_edge(ray, v1, v2);
    return perspective_functional(ray, cross(v1, v2));
}

}  // namespace detail

/// The inverse depth functional times a divisor, whose sign says which way round the edges run.
template <class Number>
struct ScaledInverseDepth {
    Number divisor;  ///< 0 where the plane holds the view ray's origin (perspective) or direction (parallel)
    Affine<Number> scaled;
};

template <class Number>
ScaledInverseDepth<Number> scaled_inverse_depth(const ViewRay<Number>& ray, const Corners<Number>& p_world) {
    const Vector3<Number> v0 = p_world[0] - ray.origin;
    const Vector3<Number> normal = cross((p_world[1] - ray.origin) - v0, (p_world[2] - ray.origin) - v0);
    if (ray.projection == Projection::perspective)
        return {dot(v0, normal), detail::perspective_functional(ray, normal)};
    return {dot(normal, ray.direction), {dot(normal, ray.step_x), dot(normal, ray.step_y), -dot(normal, v0)}};
}

/// The inverse depth of image_of() and nothing else, in the same bits.
template <class Number>
std::optional<Affine<Number>> inverse_depth_of(const ViewRay<Number>& ray, const Corners<Number>& p_world) {
    const ScaledInverseDepth<Number> plane = scaled_inverse_depth(ray, p_world);
    if (sign(plane.divisor) == 0) return std::nullopt;
    return (Number(1) / plane.divisor) * plane.scaled;
}

/// A triangle's edges before they are oriented, edge i opposite corner i: a point at which two have different
/// signs lies outside.
template <class Number>
std::array<Affine<Number>, 3> edges_of(const ViewRay<Number>& ray, const Corners<Number>& p_world) {
    const Vector3<Number> v0 = p_world[0] - ray.origin, v1 = p_world[1] - ray.origin,
                          v2 = p_world[2] - ray.origin;
    return {detail::edge_between(ray, v1, v2), detail::edge_between(ray, v2, v0),
            detail::edge_between(ray, v0, v1)};
}

/// The image of a triangle, or nothing where its plane holds the view ray's origin (perspective) or
/// direction (parallel): seen exactly edge-on it covers no area.
template <class Number>
std::optional<TriangleImage<Number>> image_of(const ViewRay<Number>& ray, const Corners<Number>& p_world) {
    const ScaledInverseDepth<Number> plane = scaled_inverse_depth(ray, p_world);
    const int orientation = sign(plane.divisor);
    if (orientation == 0) return std::nullopt;
    TriangleImage<Number> image{edges_of(ray, p_world), (Number(1) / plane.divisor) * plane.scaled};
    if (orientation < 0)
        for (auto& edge : image.edge) edge = -edge;
    return image;
}

}  // namespace zproof
