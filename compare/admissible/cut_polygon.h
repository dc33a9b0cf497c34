/// What near and far leave of a triangle, and the diagonals along which a renderer may cut that into
/// triangles.
#pragma once

#include <cmath>
#include <vector>

#include "compare/bounds/triangle_image.h"

namespace zproof {

template <class Number>
using PolygonWorld = std::vector<Vector3<Number>>;

/// The part of a convex polygon where `distance`, affine in space, is not negative.
template <class Number, class Distance>
PolygonWorld<Number> cut_by(const PolygonWorld<Number>& polygon, const Distance& distance) {
    PolygonWorld<Number> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<Number>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const Number at_p = distance(p), at_q = distance(q);
        if (sign(at_p) >= 0) left.push_back(p);
        if (sign(at_p) * sign(at_q) < 0) left.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
    return left;
}

/// Where near and far cut, as camera depths.
struct PlaneDepths {
    double near, far;
};

template <class Number>
PolygonWorld<Number> left_between(const PlaneDepths& planes, const Camera& camera,
                                  const Corners<Number>& p_world) {
    const Vector3<Number> eye = exactly<Number>(glm::dvec3(camera.eye_world)),
                          back = exactly<Number>(camera.back);
    const auto depth = [&](const Vector3<Number>& p) { return -dot(back, p - eye); };
    const Number near(planes.near), far(std::isfinite(planes.far) ? planes.far : 0);
    PolygonWorld<Number> polygon(p_world.begin(), p_world.end());
    polygon = cut_by(polygon, [&](const auto& p) { return depth(p) - near; });
    if (!std::isfinite(planes.far)) return polygon;
    return cut_by(polygon, [&](const auto& p) { return far - depth(p); });
}

/// The lines in the image through corners of the polygon that are no neighbours.
template <class Number>
std::vector<Affine<Number>> diagonals_of(const ViewRay<Number>& ray, const PolygonWorld<Number>& polygon) {
    std::vector<Affine<Number>> diagonals;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 2; j < polygon.size() - (i == 0 ? 1 : 0); ++j)
            diagonals.push_back(detail::edge_between(ray, polygon[i] - ray.origin, polygon[j] - ray.origin));
    return diagonals;
}

}  // namespace zproof
