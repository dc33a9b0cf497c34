/// The spaces that a point passes on its way into the picture, under the lessons' names.
///
/// Points are column vectors; world and camera space are right-handed, the camera looks down -z. Screen space
/// is the image plane, y up: for perspective the plane at camera depth `near`, for parallel projections the
/// plane through the eye. A screen, NDC or raster point keeps its camera depth -z_camera as z.
#pragma once

#include <array>

#include "math/vector3.h"

namespace zproof::study::projection {

template <class Number>
struct Point2 {
    Number x, y;
    bool operator==(const Point2&) const = default;
};

/// A matrix of a change of coordinates: rows[i][j] multiplies coordinate j of a column vector. (The lessons
/// multiply row vectors: their matrices are the transposes of these.)
template <class Number>
using Matrix4 = std::array<std::array<Number, 4>, 4>;

/// A homogeneous point.
template <class Number>
using Point4 = std::array<Number, 4>;

template <class Number>
Point4<Number> operator*(const Matrix4<Number>& m, const Point4<Number>& p) {
    Point4<Number> image;
    for (std::size_t i = 0; i < 4; ++i)
        image[i] = ((m[i][0] * p[0] + m[i][1] * p[1]) + m[i][2] * p[2]) + m[i][3] * p[3];
    return image;
}

template <class Number>
Matrix4<Number> operator*(const Matrix4<Number>& a, const Matrix4<Number>& b) {
    Matrix4<Number> product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            product[i][j] = ((a[i][0] * b[0][j] + a[i][1] * b[1][j]) + a[i][2] * b[2][j]) + a[i][3] * b[3][j];
    return product;
}

/// A coordinate system as a matrix, and the matrix as a coordinate system: its axes and its origin in terms
/// of the outer system. The last row is 0 0 0 1.
template <class Number>
Matrix4<Number> coordinate_system(const std::array<Vector3<Number>, 3>& axes, const Vector3<Number>& origin) {
    return {{{axes[0].x, axes[1].x, axes[2].x, origin.x},
             {axes[0].y, axes[1].y, axes[2].y, origin.y},
             {axes[0].z, axes[1].z, axes[2].z, origin.z},
             {Number(0), Number(0), Number(0), Number(1)}}};
}

/// The inverse of a coordinate system (last row 0 0 0 1, axes not in a plane) by Cramer's rule.
template <class Number>
Matrix4<Number> inverse_of(const Matrix4<Number>& m) {
    const Vector3<Number> x{m[0][0], m[1][0], m[2][0]}, y{m[0][1], m[1][1], m[2][1]},
        z{m[0][2], m[1][2], m[2][2]}, origin{m[0][3], m[1][3], m[2][3]};
    const Number volume = dot(x, cross(y, z));
    Matrix4<Number> inverse;
    const std::array<Vector3<Number>, 3> rows{cross(y, z), cross(z, x), cross(x, y)};
    for (std::size_t i = 0; i < 3; ++i)
        inverse[i] = {rows[i].x / volume, rows[i].y / volume, rows[i].z / volume,
                      -(dot(rows[i], origin) / volume)};
    inverse[3] = {Number(0), Number(0), Number(0), Number(1)};
    return inverse;
}

}  // namespace zproof::study::projection
