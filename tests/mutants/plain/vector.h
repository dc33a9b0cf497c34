/// Three numbers of one arithmetic, and what is done with them.
#pragma once

#include <array>
#include <cmath>

namespace plain {

template <class Real>
using Vec3 = std::array<Real, 3>;

template <class Real>
Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Real>
Vec3<Real> operator*(Real s, const Vec3<Real>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// cross(b, a) is exactly -cross(a, b), also where it is rounded.
template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class To, class From>
Vec3<To> rounded(const Vec3<From>& a) {
    return {To(a[0]), To(a[1]), To(a[2])};
}

}  // namespace plain
