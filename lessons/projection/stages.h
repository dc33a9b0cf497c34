/// The lessons' stages as functions under their names, for any number type: machine numbers round after every
/// operation as a program would, Rational never. Each stage is written as the operations that it is made of,
/// so that an instrument may stop between two of them (routes.h).
///
/// Sources: Scratchapixel, "Computing the Pixel Coordinates of a 3D Point" (canvas of width W and height H,
/// NDC [0, 1]) and "The Projection Stage" (near x / -z; NDC [-1, 1] by l, r, b, t); "Perspective Projection
/// II" (the frustum as a box).
#pragma once

#include "lessons/projection/camera.h"

namespace zproof::study::projection {

template <class Number>
Vector3<Number> local_to_world(const Matrix4<Number>& world_from_local, const Vector3<Number>& p_local) {
    const Point4<Number> p = world_from_local * Point4<Number>{p_local.x, p_local.y, p_local.z, Number(1)};
    return {p[0], p[1], p[2]};
}

template <class Number>
Vector3<Number> less_eye(const NumericCamera<Number>& camera, const Vector3<Number>& p_world) {
    return p_world - camera.eye;
}
template <class Number>
Vector3<Number> along_axes(const NumericCamera<Number>& camera, const Vector3<Number>& from_eye) {
    return {dot(camera.to_camera[0], from_eye), dot(camera.to_camera[1], from_eye),
            dot(camera.to_camera[2], from_eye)};
}
template <class Number>
Vector3<Number> world_to_camera(const NumericCamera<Number>& camera, const Vector3<Number>& p_world) {
    return along_axes(camera, less_eye(camera, p_world));
}

template <class Number>
Vector3<Number> times_near(const NumericCamera<Number>& camera, const Vector3<Number>& p_camera) {
    return {camera.near * p_camera.x, camera.near * p_camera.y, p_camera.z};
}
/// The perspective divide; z becomes the camera depth.
template <class Number>
Vector3<Number> over_depth(const Vector3<Number>& p) {
    return {p.x / -p.z, p.y / -p.z, -p.z};
}
/// Along the direction (shear, -1) onto the plane through the eye; z becomes the camera depth.
template <class Number>
Vector3<Number> along_shear(const NumericCamera<Number>& camera, const Vector3<Number>& p_camera) {
    return {p_camera.x + p_camera.z * camera.shear.x, p_camera.y + p_camera.z * camera.shear.y, -p_camera.z};
}
/// Perspective: near x / -z onto the near plane. Parallel: onto the plane through the eye.
template <class Number>
Vector3<Number> camera_to_screen(const NumericCamera<Number>& camera, const Vector3<Number>& p_camera) {
    return camera.projection == Projection::parallel ? along_shear(camera, p_camera)
                                                     : over_depth(times_near(camera, p_camera));
}

template <class Number>
Vector3<Number> double_over_extent(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return {Number(2) * p_screen.x / (c.right - c.left), Number(2) * p_screen.y / (c.top - c.bottom),
            p_screen.z};
}
template <class Number>
Vector3<Number> less_middle(const Canvas<Number>& c, const Vector3<Number>& p) {
    return {p.x - (c.right + c.left) / (c.right - c.left), p.y - (c.top + c.bottom) / (c.top - c.bottom),
            p.z};
}
/// NDC of the GPU's convention, [-1, 1]: 2 x / (r - l) - (r + l) / (r - l).
template <class Number>
Vector3<Number> screen_to_ndc(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return less_middle(c, double_over_extent(c, p_screen));
}

template <class Number>
Vector3<Number> less_corner(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return {p_screen.x - c.left, p_screen.y - c.bottom, p_screen.z};
}
template <class Number>
Vector3<Number> over_extent(const Canvas<Number>& c, const Vector3<Number>& p) {
    return {p.x / (c.right - c.left), p.y / (c.top - c.bottom), p.z};
}
/// NDC of RenderMan's convention, [0, 1]: (x - l) / (r - l).
template <class Number>
Vector3<Number> screen_to_unit_ndc(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return over_extent(c, less_corner(c, p_screen));
}

/// (x + W / 2, y + H / 2): of a canvas of width W and height H about the axis.
template <class Number>
Vector3<Number> plus_half_extent(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return {p_screen.x + (c.right - c.left) / Number(2), p_screen.y + (c.top - c.bottom) / Number(2),
            p_screen.z};
}
/// NDC [0, 1] of such a canvas: (x + W / 2) / W. Wrong where the canvas does not lie about the axis.
template <class Number>
Vector3<Number> centred_screen_to_unit_ndc(const Canvas<Number>& c, const Vector3<Number>& p_screen) {
    return over_extent(c, plus_half_extent(c, p_screen));
}

/// "In raster space y is down": [-1, 1] to [0, 1], y from the top.
template <class Number>
Vector3<Number> halved_from_top(const Vector3<Number>& p_ndc) {
    return {(p_ndc.x + Number(1)) / Number(2), (Number(1) - p_ndc.y) / Number(2), p_ndc.z};
}
template <class Number>
Vector3<Number> from_top(const Vector3<Number>& p_unit_ndc) {
    return {p_unit_ndc.x, Number(1) - p_unit_ndc.y, p_unit_ndc.z};
}
template <class Number>
Vector3<Number> times_pixels(const NumericCamera<Number>& camera, const Vector3<Number>& p) {
    return {p.x * camera.width, p.y * camera.height, p.z};
}
template <class Number>
Vector3<Number> ndc_to_raster(const NumericCamera<Number>& camera, const Vector3<Number>& p_ndc) {
    return times_pixels(camera, halved_from_top(p_ndc));
}
template <class Number>
Vector3<Number> unit_ndc_to_raster(const NumericCamera<Number>& camera, const Vector3<Number>& p_unit_ndc) {
    return times_pixels(camera, from_top(p_unit_ndc));
}

/// P_3 = (f + n - 2 f n / z) / (f - n) of the camera depth z: near becomes -1, far 1, and lines stay lines.
/// Infinite far: 1 - 2 n / z. Parallel projections: (2 z - f - n) / (f - n).
template <class Number>
Number depth_to_ndc(const NumericCamera<Number>& camera, const Number& depth) {
    const Number n = camera.near, f = camera.far, two = Number(2);
    if (!camera.has_far) return Number(1) - two * n / depth;
    if (camera.projection == Projection::parallel) return (two * depth - f - n) / (f - n);
    return (f + n - two * f * n / depth) / (f - n);
}

/// The frustum of a camera onto the box [-1, 1]^3. The depth of the point must not be 0 for perspective.
template <class Number>
Vector3<Number> camera_to_box(const NumericCamera<Number>& camera, const Vector3<Number>& p_camera) {
    const Vector3<Number> p_ndc = screen_to_ndc(camera.on_near, camera_to_screen(camera, p_camera));
    return {p_ndc.x, p_ndc.y, depth_to_ndc(camera, p_ndc.z)};
}

}  // namespace zproof::study::projection
