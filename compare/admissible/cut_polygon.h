/// What near and far leave of a triangle, and the diagonals along which a renderer may cut that into
/// triangles.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "compare/bounds/triangle_image.h"
#include "math/rational.h"

namespace zproof {

template <class Number>
using PolygonWorld = std::vector<Vector3<Number>>;

/// Where a plane cuts, and whether corners on it are left: it is seen from places of it that leave them.
template <class Number>
struct CutDepth {
    Number depth;
    bool leaves_corners;
};

/// The part of a convex polygon where `distance`, affine in space, is above 0; 0, where that is left.
template <class Number, class Distance>
PolygonWorld<Number> cut_by(const PolygonWorld<Number>& polygon, bool leaves_corners,
                            const Distance& distance) {
    const auto is_left = [&](const Number& at) { return sign(at) > 0 || (leaves_corners && sign(at) == 0); };
    PolygonWorld<Number> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<Number>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const Number at_p = distance(p), at_q = distance(q);
        if (is_left(at_p)) left.push_back(p);
        if (is_left(at_p) != is_left(at_q)) left.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
    return left;
}

template <class Number>
class CutTriangle {
  public:
    CutTriangle(const Camera& camera, const Corners<Number>& p_world)
        : eye_(exactly<Number>(glm::dvec3(camera.eye_world))),
          back_(exactly<Number>(camera.back)),
          p_world_(p_world.begin(), p_world.end()) {}

    PolygonWorld<Number> left_between(const CutDepth<Number>& near,
                                      const std::optional<CutDepth<Number>>& far) const {
        auto left =
            cut_by(p_world_, near.leaves_corners, [&](const auto& p) { return depth(p) - near.depth; });
        if (!far) return left;
        return cut_by(left, far->leaves_corners, [&](const auto& p) { return far->depth - depth(p); });
    }

    /// From `low` to `high`, and the depths of corners between: what is left has as many corners from each to
    /// the next.
    std::vector<Number> steps(double low, double high) const {
        std::vector<Number> steps{Number(low)};
        for (const auto& p : p_world_)
            if (sign(depth(p) - Number(low)) > 0 && sign(Number(high) - depth(p)) > 0)
                steps.push_back(depth(p));
        std::sort(steps.begin(), steps.end(),
                  [](const Number& a, const Number& b) { return sign(b - a) > 0; });
        steps.push_back(Number(high));
        return steps;
    }

  private:
    Number depth(const Vector3<Number>& p) const { return -dot(back_, p - eye_); }

    Vector3<Number> eye_, back_;
    PolygonWorld<Number> p_world_;
};

/// The lines in the image through corners of the polygon that are no neighbours.
template <class Number>
std::vector<Affine<Number>> diagonals_of(const ViewRay<Number>& ray, const PolygonWorld<Number>& polygon) {
    std::vector<Affine<Number>> diagonals;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 2; j < polygon.size() - (i == 0 ? 1 : 0); ++j)
            diagonals.push_back(detail::edge_between(ray, polygon[i] - ray.origin, polygon[j] - ray.origin));
    return diagonals;
}

/// Does a diagonal of one of the polygons lie within half_side_px of the ray's pixel centre, or on another
/// side of it than in another of them?
template <class Number>
bool do_diagonals_pass(const ViewRay<Number>& ray, const Number& half_side_px,
                       const std::vector<PolygonWorld<Number>>& polygons) {
    std::vector<int> sides;  // of the centre, by diagonal
    for (const auto& polygon : polygons) {
        std::vector<int> here;
        for (const auto& f : diagonals_of(ray, polygon)) {
            if (sign(half_side_px * (magnitude(f.a) + magnitude(f.b)) - magnitude(f.c)) >= 0) return true;
            here.push_back(sign(f.c));
        }
        if (&polygon != &polygons.front() && here != sides) return true;
        sides = here;
    }
    return false;
}

}  // namespace zproof
