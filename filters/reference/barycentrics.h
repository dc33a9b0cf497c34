/// Homogeneous barycentrics of a triangle as the image sees it, affine in the raster position.
///
/// With corners v_i relative to the eye and the view ray d through (x, y), b_i = (v_j x v_k) . d. All three
/// have the sign of facing() where the ray meets the triangle's cone.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "math/affine.h"
#include "math/vector3.h"
#include "scenes/view.h"

namespace zproof::oracle::filter_reference {

/// The value of an expression with every term in absolute value; rounding errors are relative to it.
struct Magnitude {
    double value = 0;
    Magnitude(double of = 0) : value(std::abs(of)) {}

    friend Magnitude operator+(Magnitude a, Magnitude b) { return {a.value + b.value}; }
    friend Magnitude operator-(Magnitude a, Magnitude b) { return {a.value + b.value}; }
    friend Magnitude operator-(Magnitude a) { return a; }
    friend Magnitude operator*(Magnitude a, Magnitude b) { return {a.value * b.value}; }
    friend Magnitude operator/(Magnitude a, Magnitude b) { return {a.value / b.value}; }  ///< b exact
};

template <class Number>
using Corners = std::array<Vector3<Number>, 3>;

/// Corners relative to the eye.
template <class Number>
Corners<Number> corners_from_eye(const View& view, const std::array<glm::vec3, 3>& corners_world) {
    const auto eye = exactly<Number>(glm::dvec3{view.camera.eye_world});
    const auto from_eye = [&](std::size_t i) { return exactly<Number>(glm::dvec3{corners_world[i]}) - eye; };
    return {from_eye(0), from_eye(1), from_eye(2)};
}

namespace detail {

template <class Number>
struct AffineVector {
    Vector3<Number> x, y, c;

    Affine<Number> dot_with(const Vector3<Number>& a) const { return {dot(a, x), dot(a, y), dot(a, c)}; }
};

/// Raster position -> u right + v up (scenes/camera.h).
template <class Number>
AffineVector<Number> on_window(const View& view) {
    const Window& window = view.camera.window;
    const auto right = exactly<Number>(view.camera.right), up = exactly<Number>(view.camera.up);
    const Number left{window.left}, top{window.top};
    return {(Number(window.right) - left) / Number(view.width) * right,
            (Number(window.bottom) - top) / Number(view.height) * up, left * right + top * up};
}

/// What all view rays of a parallel projection have in common: a step of depth 1.
template <class Number>
Vector3<Number> sheared_axis(const Camera& camera) {
    return Number(camera.shear.x) * exactly<Number>(camera.right) +
           Number(camera.shear.y) * exactly<Number>(camera.up) - exactly<Number>(camera.back);
}

}  // namespace detail

/// b_i = (p x q) . d for the two other corners p, q. Perspective: d = u right + v up - back. Parallel: the
/// origin o = u right + v up moves instead, and ((p - o) x (q - o)) . d = (p x q) . d + o . ((p - q) x d).
template <class Number>
std::array<Affine<Number>, 3> barycentric_functionals(const View& view, const Corners<Number>& corner) {
    const Camera& camera = view.camera;
    const auto window = detail::on_window<Number>(view);
    const auto back = exactly<Number>(camera.back), sheared = detail::sheared_axis<Number>(camera);
    std::array<Affine<Number>, 3> b;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3<Number>&p = corner[(i + 1) % 3], &q = corner[(i + 2) % 3];
        if (camera.projection == Projection::perspective) {
            b[i] = window.dot_with(cross(p, q));
            b[i].c = b[i].c - dot(cross(p, q), back);
        } else {
            b[i] = window.dot_with(cross(p - q, sheared));
            b[i].c = b[i].c + dot(cross(p, q), sheared);
        }
    }
    return b;
}

/// Its sign says which way round the corners are seen; 0: edge-on. Perspective: the determinant of the
/// corners. Parallel: the normal along the rays, which is also b_0 + b_1 + b_2.
template <class Number>
Number facing(const View& view, const Corners<Number>& corner) {
    if (view.camera.projection == Projection::perspective) return dot(corner[0], cross(corner[1], corner[2]));
    return dot(cross(corner[1] - corner[0], corner[2] - corner[0]),
               detail::sheared_axis<Number>(view.camera));
}

/// Greater is nearer, once divided by facing(): 1 / depth, or -depth of parallel projections.
template <class Number>
Affine<Number> inverse_depth_functional(const View& view, const Corners<Number>& corner,
                                        const std::array<Affine<Number>, 3>& b) {
    if (view.camera.projection == Projection::perspective) return b[0] + b[1] + b[2];
    const auto back = exactly<Number>(view.camera.back);
    return dot(corner[0], back) * b[0] + dot(corner[1], back) * b[1] + dot(corner[2], back) * b[2];
}

}  // namespace zproof::oracle::filter_reference
