/// Triangles seen exactly edge-on. They cover no area, but a renderer that moves their corners by eps may
/// draw them: each edge then stands as a segment of the image with the inverse depth that holds along it.
#pragma once

#include <optional>

#include "compare/bounds/triangle_image.h"
#include "math/rational.h"

namespace zproof {

/// A segment of the image: f = 0 between two half-planes.
template <class Number>
struct SegmentImage {
    Affine<Number> line, after_start, before_end;  ///< the last two are >= 0 on the segment
    Affine<Number> inverse_depth;                  ///< right on the segment, arbitrary elsewhere
};

namespace detail {

/// A vector that is not in the plane of a and b: the axis along which a x b is largest.
template <class Number>
Vector3<Number> axis_off(const Vector3<Number>& a_cross_b) {
    const Number x = magnitude(a_cross_b.x), y = magnitude(a_cross_b.y), z = magnitude(a_cross_b.z);
    if (sign(x - y) >= 0 && sign(x - z) >= 0) return {Number(1), Number(0), Number(0)};
    if (sign(y - z) >= 0) return {Number(0), Number(1), Number(0)};
    return {Number(0), Number(0), Number(1)};
}

template <class Number>
bool is_zero(const Vector3<Number>& v) {
    return sign(v.x) == 0 && sign(v.y) == 0 && sign(v.z) == 0;
}

template <class Number>
SegmentImage<Number> perspective_segment(const ViewRay<Number>& ray, const Vector3<Number>& a,
                                         const Vector3<Number>& b, const Vector3<Number>& moment) {
    const Vector3<Number> plane = cross(b - a, axis_off(moment));
    return {perspective_functional(ray, moment), perspective_functional(ray, cross(moment, a)),
            perspective_functional(ray, cross(b, moment)),
            (Number(1) / dot(a, plane)) * perspective_functional(ray, plane)};
}

/// The functional e -> (e - p) . normal of a plane that holds the direction of the view ray.
template <class Number>
Affine<Number> beyond(const ViewRay<Number>& ray, const Vector3<Number>& p, const Vector3<Number>& normal) {
    return {dot(normal, ray.step_x), dot(normal, ray.step_y), -dot(normal, p)};
}

template <class Number>
SegmentImage<Number> parallel_segment(const ViewRay<Number>& ray, const Vector3<Number>& a,
                                      const Vector3<Number>& b, const Vector3<Number>& side) {
    const Vector3<Number> along = cross(ray.direction, side);
    const Vector3<Number> plane = cross(b - a, side);
    return {parallel_edge(ray, a, b), beyond(ray, a, along), -beyond(ray, b, along),
            (Number(-1) / dot(plane, ray.direction)) *
                Affine<Number>{-dot(plane, ray.step_x), -dot(plane, ray.step_y), dot(plane, a)}};
}

}  // namespace detail

/// Does the triangle, seen edge-on, hold the view ray's origin? That of a parallel view is in no triangle.
template <class Number>
bool holds_eye(const ViewRay<Number>& ray, const Corners<Number>& p_world) {
    if (ray.projection == Projection::parallel) return false;
    const Vector3<Number> v0 = p_world[0] - ray.origin, v1 = p_world[1] - ray.origin,
                          v2 = p_world[2] - ray.origin;
    const Vector3<Number> m0 = cross(v0, v1), m1 = cross(v1, v2), m2 = cross(v2, v0);
    return sign(dot(m0, m1)) >= 0 && sign(dot(m1, m2)) >= 0 && sign(dot(m2, m0)) >= 0;
}

/// The image of the segment from a to b (world space), or nothing where it is seen end-on.
template <class Number>
std::optional<SegmentImage<Number>> segment_image(const ViewRay<Number>& ray, const Vector3<Number>& a_world,
                                                  const Vector3<Number>& b_world) {
    const Vector3<Number> a = a_world - ray.origin, b = b_world - ray.origin;
    const bool perspective = ray.projection == Projection::perspective;
    const Vector3<Number> moment = perspective ? cross(a, b) : cross(b - a, ray.direction);
    if (detail::is_zero(moment)) return std::nullopt;
    return perspective ? detail::perspective_segment(ray, a, b, moment)
                       : detail::parallel_segment(ray, a, b, moment);
}

/// The image of a corner, as a segment without length; nothing where it does not lie before a perspective's
/// eye.
template <class Number>
std::optional<SegmentImage<Number>> point_image(const ViewRay<Number>& ray, const Vector3<Number>& p_world) {
    const Vector3<Number> p = p_world - ray.origin;
    const Number depth = camera_depth(ray, p), none(0);
    const bool perspective = ray.projection == Projection::perspective;
    if (perspective && sign(depth) <= 0) return std::nullopt;
    const Vector3<Number> axis = detail::axis_off(perspective ? p : ray.direction);
    const auto through = [&](const Vector3<Number>& other) {
        return perspective ? detail::perspective_functional(ray, cross(p, other))
                           : detail::beyond(ray, p, cross(ray.direction, other));
    };
    const Affine<Number> across = through({axis.z, axis.x, axis.y});
    return SegmentImage<Number>{through({axis.y, axis.z, axis.x}), across, -across,
                                Affine<Number>{none, none, perspective ? Number(1) / depth : -depth}};
}

}  // namespace zproof
