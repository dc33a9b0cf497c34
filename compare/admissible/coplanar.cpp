#include "compare/admissible/coplanar.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "math/interval.h"
#include "math/rounding.h"
#include "math/vector3.h"

namespace zproof {

namespace {

/// Every finite float32 is an integer times 2^-149 and below 2^128: 277 bits, so an edge has 278 and the
/// triple product 3 * 278 + 3 < 1024.
using Exact = boost::multiprecision::int1024_t;

Exact times_2_to_149(float value) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);
    const auto integer = static_cast<std::int64_t>(std::ldexp(mantissa, 24));
    const int shift = exponent - 24 + 149;
    return shift >= 0 ? Exact(integer) << unsigned(shift) : Exact(integer / (std::int64_t{1} << -shift));
}

Vector3<Exact> times_2_to_149(const glm::vec3& p) {
    return {times_2_to_149(p.x), times_2_to_149(p.y), times_2_to_149(p.z)};
}

int sign(const Exact& n) { return n.sign(); }

/// Number's corners of a, then whether those of b lie in their plane.
template <class Number, class Convert>
bool all_in_plane(const CornersWorld& a, const CornersWorld& b, const Convert& convert) {
    const Vector3<Number> origin = convert(a[0]);
    const Vector3<Number> normal = cross(convert(a[1]) - origin, convert(a[2]) - origin);
    return std::ranges::all_of(
        b, [&](const glm::vec3& p) { return sign(dot(normal, convert(p) - origin)) == 0; });
}

template <class Number, class Convert>
bool on_one_line(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Convert& convert) {
    const Vector3<Number> origin = convert(a);
    const Vector3<Number> normal = cross(convert(b) - origin, convert(c) - origin);
    return sign(normal.x) == 0 && sign(normal.y) == 0 && sign(normal.z) == 0;
}

Vector3<Interval> as_interval(const glm::vec3& p) { return exactly<Interval>(glm::dvec3(p)); }

/// Can double precision tell that they do not lie on one line? Most do not; a coordinate of the normal has
/// four roundings in each of its two products.
bool are_certainly_apart(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    static const double rounding = gamma(4, unit_roundoff_float64);
    const glm::dvec3 p = b - a, q = c - a;
    const auto apart = [](double product, double other) {
        return std::abs(product - other) > 2 * rounding * (std::abs(product) + std::abs(other));
    };
    return apart(p.y * q.z, p.z * q.y) || apart(p.z * q.x, p.x * q.z) || apart(p.x * q.y, p.y * q.x);
}

}  // namespace

bool collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    if (are_certainly_apart(glm::dvec3(a), glm::dvec3(b), glm::dvec3(c))) return false;
    try {
        return on_one_line<Interval>(a, b, c, as_interval);
    } catch (const UndecidedSign&) {
        return on_one_line<Exact>(a, b, c, [](const glm::vec3& p) { return times_2_to_149(p); });
    }
}

Slope slope_of(const glm::vec3& a, const glm::vec3& b) {
    constexpr glm::dvec3 above{1, 0.3, -0.7},
        below{-0.4, 1, 0.6};  // no direction of a grid is square to them
    static const double rounding = 2 * gamma(8, unit_roundoff_float64);
    const glm::dvec3 d = glm::dvec3(b) - glm::dvec3(a);
    const double size = std::abs(d.x) + std::abs(d.y) + std::abs(d.z), divisor = dot(d, below);
    if (std::abs(divisor) <= rounding * size) return {0, HUGE_VAL};
    const double value = dot(d, above) / divisor;
    return {value, rounding * size * (1 + std::abs(value)) / std::abs(divisor)};
}

bool coplanar(const CornersWorld& a, const CornersWorld& b) {
    try {
        return all_in_plane<Interval>(a, b, as_interval);
    } catch (const UndecidedSign&) {
        return all_in_plane<Exact>(a, b, [](const glm::vec3& p) { return times_2_to_149(p); });
    }
}

}  // namespace zproof
