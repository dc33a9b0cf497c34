/// How large a triangle is as error analysis sees it: sums of absolute products, the same for every renderer
/// of a view (docs/bounds.md, "A triangle's size"). In double, or four at a time.
#pragma once

#include <array>
#include <limits>

#include "compare/bounds/four.h"
#include "compare/bounds/triangle_image.h"
#include "math/rounding.h"

namespace zproof {

/// Sums of absolute products behind nearness = (normal . direction) / volume: how ill-conditioned it is.
/// Parallel projections: depth = (normal . corner) / facing, in the same places.
template <class Number>
struct PlaneSizeOf {
    Number volume{}, volume_abs{}, numerator_abs{};
    /// Parallel projections: what the judge's own rounding of the origin of sight may add to the numerator.
    Number origin_error{};
};
using PlaneSize = PlaneSizeOf<double>;

/// Forward error of the judge's own nearness, computed in double by image_of: absolute sums of both products,
/// 16 roundings at most in each.
template <class Number>
class PlaneErrorOf {
  public:
    PlaneErrorOf() = default;
    explicit PlaneErrorOf(const PlaneSizeOf<Number>& size)
        : condition_(size.volume_abs / size.volume),
          numerator_(size.numerator_abs / size.volume),
          of_origin_(2.0 * size.origin_error / size.volume),
          is_known_(rounding * condition_ < 0.5) {}

    /// Is the plane's orientation, as seen, certain?
    auto is_known() const { return is_known_; }
    /// Where |nearness| is at most this.
    Number at(const Number& largest_nearness) const {
        const Number error = known_at(largest_nearness);
        return is_known_ ? error : everywhere<Number>(std::numeric_limits<double>::infinity());
    }
    /// The same where the orientation is known.
    Number known_at(const Number& largest_nearness) const {
        return 2 * rounding * (numerator_ + largest_nearness * condition_) + of_origin_;
    }

  private:
    static constexpr double rounding = gamma(16, unit_roundoff_float64);
    Number condition_{}, numerator_{}, of_origin_{};
    decltype(Number{} < 0.5) is_known_{};
};
using PlaneError = PlaneErrorOf<double>;

template <class Number>
struct TriangleSize {
    std::array<Number, 3> depth;  ///< of the corners
    Vector3<Number> from_eye;     ///< max over corners of sum |axis_j| |p_j - eye_j|
    Vector3<Number> from_origin;  ///< max over corners of sum |axis_j| (|p_j| + |eye_j|)
    PlaneSizeOf<Number> plane;
};

template <class Number>
Vector3<Number> absolute(const Vector3<Number>& v) {
    return {absolute(v.x), absolute(v.y), absolute(v.z)};
}

/// |a| x |b| with every term in absolute value.
template <class Number>
Vector3<Number> absolute_cross(const Vector3<Number>& a, const Vector3<Number>& b) {
    const Vector3<Number> p = absolute(a), q = absolute(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

/// What the triangles of one view are measured with.
template <class Number>
struct Gauge {
    Projection projection = Projection::perspective;
    Vector3<Number> eye, eye_abs, back;
    std::array<Vector3<Number>, 3> axes_abs;  ///< the camera's: right, up, back
    Vector3<Number> direction;                ///< of sight; parallel projections only
    Vector3<Number> direction_abs;            ///< per world axis, the largest |direction| in the image
    Vector3<Number> origin_abs;               ///< per world axis, the largest |origin - eye|

    TriangleSize<Number> operator()(const Corners<Number>& p_world) const {
        const Vector3<Number> v[] = {p_world[0] - eye, p_world[1] - eye, p_world[2] - eye};
        TriangleSize<Number> size;
        size.depth = {-dot(back, v[0]), -dot(back, v[1]), -dot(back, v[2])};
        size.from_eye =
            largest(absolute(v[0]) + origin_abs, absolute(v[1]) + origin_abs, absolute(v[2]) + origin_abs);
        size.from_origin = largest(absolute(p_world[0]) + eye_abs, absolute(p_world[1]) + eye_abs,
                                   absolute(p_world[2]) + eye_abs);
        size.plane = plane_size(v[0], p_world);
        return size;
    }

  private:
    Vector3<Number> largest(const Vector3<Number>& a, const Vector3<Number>& b,
                            const Vector3<Number>& c) const {
        const auto along = [&](const Vector3<Number>& axis) {
            return larger(larger(dot(axis, a), dot(axis, b)), dot(axis, c));
        };
        return {along(axes_abs[0]), along(axes_abs[1]), along(axes_abs[2])};
    }

    PlaneSizeOf<Number> plane_size(const Vector3<Number>& v0, const Corners<Number>& p) const {
        const Vector3<Number> e1 = p[1] - p[0], e2 = p[2] - p[0];
        const Vector3<Number> normal = cross(e1, e2);
        const Vector3<Number> normal_abs =
            absolute_cross(e1, e2) + absolute_cross(e1, e2 - e1) + absolute_cross(e2, e2 - e1);
        const Number from_corner = dot(absolute(v0) + origin_abs, normal_abs);
        const Number along_sight = dot(direction_abs, normal_abs);
        if (projection == Projection::perspective)
            return {absolute(dot(v0, normal)), from_corner, along_sight, Number{}};
        constexpr double rounding = gamma(6, unit_roundoff_float64);
        return {absolute(dot(direction, normal)), along_sight, from_corner,
                rounding * dot(eye_abs + origin_abs, normal_abs)};
    }
};

}  // namespace zproof
