/// A triangle cut by the six planes of the view volume.
#pragma once

#include "tests/mutants/plain/projector.h"

namespace plain {

enum class Plane { near, far, left, right, bottom, top };

template <class Real>
struct Polygon {
    static constexpr int capacity = 16;  ///< a triangle and six planes make nine

    std::array<ClipVertex<Real>, capacity> corners;
    int size = 0;

    void add(const ClipVertex<Real>& corner) {
        if (size < capacity) corners[std::size_t(size++)] = corner;
    }
};

/// Not below 0 inside.
template <class Real>
Real distance(Plane plane, const ClipVertex<Real>& v, const Camera& camera) {
    switch (plane) {
        case Plane::near:
            return v.depth - Real(camera.near);
        case Plane::far:
            return Real(camera.far) - v.depth;
        case Plane::left:
            return v.w + v.x;
        case Plane::right:
            return v.w - v.x;
        case Plane::bottom:
            return v.w + v.y;
        default:
            return v.w - v.y;
    }
}

/// From the outer end on, so that both triangles of an edge get the same corner.
template <class Real>
ClipVertex<Real> cut(const ClipVertex<Real>& out, const ClipVertex<Real>& in, Real d_out, Real d_in) {
    const Real t = d_out / (d_out - d_in);
    return {.x = out.x + t * (in.x - out.x),
            .y = out.y + t * (in.y - out.y),
            .z = out.z + t * (in.z - out.z),
            .w = out.w + t * (in.w - out.w),
            .depth = out.depth + t * (in.depth - out.depth)};
}

template <class Real>
Polygon<Real> clipped_by(Plane plane, const Polygon<Real>& polygon, const Camera& camera) {
    Polygon<Real> kept;
    for (int i = 0; i < polygon.size; ++i) {
        const auto& a = polygon.corners[std::size_t(i)];
        const auto& b = polygon.corners[std::size_t((i + 1) % polygon.size)];
        const Real d_a = distance(plane, a, camera), d_b = distance(plane, b, camera);
        if (d_a >= 0) kept.add(a);
        if (d_a >= 0 && d_b < 0) kept.add(cut(b, a, d_b, d_a));
        if (d_a < 0 && d_b >= 0) kept.add(cut(a, b, d_a, d_b));
    }
    return kept;
}

template <class Real>
Polygon<Real> clipped(const Polygon<Real>& triangle, const Camera& camera) {
    Polygon<Real> polygon = triangle;
    for (const Plane plane : {Plane::near, Plane::far, Plane::left, Plane::right, Plane::bottom, Plane::top})
        polygon = clipped_by(plane, polygon, camera);
    return polygon;
}

}  // namespace plain
