/// The stages as 4 x 4 matrices.
#pragma once

#include "lessons/projection/camera.h"

namespace zproof::study::projection {

/// World to camera space: the rows of to_camera, and the eye at the origin.
template <class Number>
Matrix4<Number> camera_matrix(const NumericCamera<Number>& camera) {
    Matrix4<Number> m;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3<Number>& row = camera.to_camera[i];
        m[i] = {row.x, row.y, row.z, -dot(row, camera.eye)};
    }
    m[3] = {Number(0), Number(0), Number(0), Number(1)};
    return m;
}

/// Camera to clip space, after Scratchapixel's l, r, b, t, n, f: w is the camera depth for perspective, else
/// 1. Row 2 maps near to -1 and far to 1.
template <class Number>
Matrix4<Number> projection_matrix(const NumericCamera<Number>& camera) {
    const Canvas<Number>& c = camera.on_near;
    const Number zero(0), one(1), two(2), across = c.right - c.left, up = c.top - c.bottom, n = camera.near,
                                          f = camera.far;
    if (camera.projection == Projection::parallel)
        return {{{two / across, zero, two * camera.shear.x / across, -((c.right + c.left) / across)},
                 {zero, two / up, two * camera.shear.y / up, -((c.top + c.bottom) / up)},
                 {zero, zero, -(two / (f - n)), -((f + n) / (f - n))},
                 {zero, zero, zero, one}}};
    const Number a = camera.has_far ? -((f + n) / (f - n)) : -one;
    const Number b = camera.has_far ? -(two * f * n / (f - n)) : -(two * n);
    return {{{two * n / across, zero, (c.right + c.left) / across, zero},
             {zero, two * n / up, (c.top + c.bottom) / up, zero},
             {zero, zero, a, b},
             {zero, zero, -one, zero}}};
}

/// NDC to raster space; z is left alone.
template <class Number>
Matrix4<Number> viewport_matrix(const NumericCamera<Number>& camera) {
    const Number zero(0), one(1), half_width = camera.width / Number(2),
                                  half_height = camera.height / Number(2);
    return {{{half_width, zero, zero, half_width},
             {zero, -half_height, zero, half_height},
             {zero, zero, one, zero},
             {zero, zero, zero, one}}};
}

}  // namespace zproof::study::projection
