/// How large a triangle is as error analysis sees it: sums of absolute products, the same for every renderer
/// of a view (docs/bounds.md, "A triangle's size").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compare/bounds/triangle_image.h"
#include "math/rounding.h"

namespace zproof {

/// Sums of absolute products behind inverse depth = (normal . direction) / volume: how ill-conditioned it is.
/// Parallel projections: depth = (normal . corner) / facing, in the same places.
struct PlaneSize {
    double volume{}, volume_abs{}, numerator_abs{};
    /// Parallel projections: what the judge's own rounding of the origin of the view ray may add to the
    /// numerator.
    double origin_error{};
};

/// Forward error of the judge's own inverse depth, computed in double by image_of: absolute sums of both
/// products, 16 roundings at most in each.
class PlaneError {
  public:
    PlaneError() = default;
    explicit PlaneError(const PlaneSize& size)
        : condition_(size.volume_abs / size.volume),
          numerator_(size.numerator_abs / size.volume),
          of_origin_(2.0 * size.origin_error / size.volume),
          is_known_(rounding * condition_ < 0.5) {}

    /// Is the plane's orientation, as seen, certain?
    bool is_known() const { return is_known_; }
    /// The error where |inverse depth| is at most `largest_inverse_depth`.
    double at(double largest_inverse_depth) const {
        const double error = 2 * rounding * (numerator_ + largest_inverse_depth * condition_) + of_origin_;
        return is_known_ ? error : std::numeric_limits<double>::infinity();
    }

  private:
    static constexpr double rounding = gamma(16, unit_roundoff_float64);
    double condition_{}, numerator_{}, of_origin_{};
    bool is_known_ = false;
};

struct TriangleSize {
    std::array<double, 3> depth;  ///< of the corners
    Vector3<double> from_eye;     ///< max over corners of sum |axis_j| |p_j - eye_j|
    Vector3<double> from_origin;  ///< max over corners of sum |axis_j| (|p_j| + |eye_j|)
    PlaneSize plane;
};

inline Vector3<double> absolute(const Vector3<double>& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// |a| x |b| with every term in absolute value.
inline Vector3<double> absolute_cross(const Vector3<double>& a, const Vector3<double>& b) {
    const Vector3<double> p = absolute(a), q = absolute(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

/// What the triangles of one view are measured with.
struct Gauge {
    Projection projection = Projection::perspective;
    Vector3<double> eye, eye_abs, back;
    std::array<Vector3<double>, 3> axes_abs;  ///< the camera's: right, up, back
    Vector3<double> direction;                ///< of the view rays; parallel projections only
    Vector3<double> direction_abs;            ///< per world axis, the largest |direction| in the image
    Vector3<double> origin_abs;               ///< per world axis, the largest |origin - eye|

    TriangleSize operator()(const Corners<double>& p_world) const {
        const Vector3<double> v[] = {p_world[0] - eye, p_world[1] - eye, p_world[2] - eye};
        TriangleSize size;
        size.depth = {-dot(back, v[0]), -dot(back, v[1]), -dot(back, v[2])};
        size.from_eye =
            largest(absolute(v[0]) + origin_abs, absolute(v[1]) + origin_abs, absolute(v[2]) + origin_abs);
        size.from_origin = largest(absolute(p_world[0]) + eye_abs, absolute(p_world[1]) + eye_abs,
                                   absolute(p_world[2]) + eye_abs);
        size.plane = plane_size(v[0], p_world);
        return size;
    }

  private:
    Vector3<double> largest(const Vector3<double>& a, const Vector3<double>& b,
                            const Vector3<double>& c) const {
        const auto along = [&](const Vector3<double>& axis) {
            return std::max(std::max(dot(axis, a), dot(axis, b)), dot(axis, c));
        };
        return {along(axes_abs[0]), along(axes_abs[1]), along(axes_abs[2])};
    }

    PlaneSize plane_size(const Vector3<double>& v0, const Corners<double>& p) const {
        const Vector3<double> e1 = p[1] - p[0], e2 = p[2] - p[0];
        const Vector3<double> normal = cross(e1, e2);
        const Vector3<double> normal_abs =
            absolute_cross(e1, e2) + absolute_cross(e1, e2 - e1) + absolute_cross(e2, e2 - e1);
        const double from_corner = dot(absolute(v0) + origin_abs, normal_abs);
        const double along_ray = dot(direction_abs, normal_abs);
        if (projection == Projection::perspective)
            return {std::abs(dot(v0, normal)), from_corner, along_ray, 0};
        constexpr double rounding = gamma(6, unit_roundoff_float64);
        return {std::abs(dot(direction, normal)), along_ray, from_corner,
                rounding * dot(eye_abs + origin_abs, normal_abs)};
    }
};

}  // namespace zproof
