#include "tests/mutants/plain/caster.h"

#include "tests/mutants/plain/methods.h"

namespace plain {
namespace {

/// Which side of the edge from a to b the ray passes. Exactly the negative for the edge from b to a.
template <class Real>
Real side(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& direction) {
    return dot(cross(b - a, b + a), direction);
}

std::optional<float> meet_by_sides(const Triangle& t, const Ray<float>& ray) {
    const Vec3<float> a = t.corners[0] - ray.origin;
    const Vec3<float> b = t.corners[1] - ray.origin;
    const Vec3<float> c = t.corners[2] - ray.origin;
    const float of_a = side(b, c, ray.direction), of_b = side(c, a, ray.direction);
    const float of_c = side(a, b, ray.direction);
    const bool is_left = of_a >= 0 && of_b >= 0 && of_c >= 0, is_right = of_a <= 0 && of_b <= 0 && of_c <= 0;
    if (!is_left && !is_right) return std::nullopt;
    const Vec3<float> normal = cross(b - a, c - a);
    const float along = dot(normal, ray.direction);
    if (along == 0) return std::nullopt;
    return dot(normal, a) / along;
}

std::optional<double> meet_by_weights(const Triangle& t, const Ray<double>& ray) {
    const auto corner = rounded<double>(t.corners[0]);
    const Vec3<double> e1 = rounded<double>(t.corners[1]) - corner,
                       e2 = rounded<double>(t.corners[2]) - corner;
    const Vec3<double> from_corner = ray.origin - corner;
    const Vec3<double> p = cross(ray.direction, e2), q = cross(from_corner, e1);
    const double determinant = dot(e1, p);
    if (determinant == 0) return std::nullopt;
    const double u = dot(from_corner, p) / determinant, v = dot(ray.direction, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    return dot(e2, q) / determinant;
}

}  // namespace

Picture cast_pluecker(const Mesh& mesh, const Camera& camera) {
    return cast<float>(mesh, camera, meet_by_sides);
}

Picture cast_moeller_trumbore(const Mesh& mesh, const Camera& camera) {
    return cast<double>(mesh, camera, meet_by_weights);
}

}  // namespace plain
