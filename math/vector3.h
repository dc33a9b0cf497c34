/// Three-dimensional vectors over any number type of ours (double, Interval, Rational).
#pragma once

#include <glm/glm.hpp>

namespace zproof {

template <class Number>
struct Vector3 {
    Number x, y, z;

    friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector3 operator*(const Number& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A vector of machine numbers as exact numbers.
template <class Number>
Vector3<Number> exactly(const glm::dvec3& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
}

}  // namespace zproof
