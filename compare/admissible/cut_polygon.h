/// What clipping leaves of a triangle, and the diagonals along which a renderer may cut that into triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "compare/bounds/triangle_image.h"
#include "math/rational.h"

namespace zproof {

template <class Number>
using PolygonWorld = std::vector<Vector3<Number>>;

/// Clips to where value > place * weight, both affine in space, for a place from `low` to `high`.
template <class Number>
class CutPlane {
  public:
    Vector3<Number> eye, value, weight;  ///< the latter two as gradients; value is 0 at the eye
    Number weight_at_eye;
    double low, high;

    bool is_known() const { return low == high; }

    /// Does it leave the point from wherever it cuts?
    bool leaves(const Vector3<Number>& p) const { return sign(distance(p, Number(high))) > 0; }

    /// The part of a convex polygon that is left by the plane at the place; corners on it only if they are
    /// left by the plane close to it as well.
    PolygonWorld<Number> left_of(const PolygonWorld<Number>& polygon, const Number& place,
                                 bool leaves_corners) const {
        const auto is_left = [&](const Number& at) {
            return sign(at) > 0 || (leaves_corners && sign(at) == 0);
        };
        PolygonWorld<Number> left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector3<Number>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const Number at_p = distance(p, place), at_q = distance(q, place);
            if (is_left(at_p)) left.push_back(p);
            if (is_left(at_p) != is_left(at_q)) left.push_back(p + (at_p / (at_p - at_q)) * (q - p));
        }
        return left;
    }

    /// From `low` to `high`, and the places of corners between: what is left has as many corners from each to
    /// the next.
    std::vector<Number> steps(const PolygonWorld<Number>& corners) const {
        std::vector<Number> steps{Number(low)};
        for (const auto& p : corners)
            if (sign(weight_of(p)) > 0 && sign(distance(p, Number(low))) > 0 &&
                sign(distance(p, Number(high))) < 0)
                steps.push_back(dot(value, p - eye) / weight_of(p));
        std::sort(steps.begin(), steps.end(),
                  [](const Number& a, const Number& b) { return sign(b - a) > 0; });
        steps.push_back(Number(high));
        return steps;
    }

  private:
    Number weight_of(const Vector3<Number>& p) const { return dot(weight, p - eye) + weight_at_eye; }
    Number distance(const Vector3<Number>& p, const Number& place) const {
        return dot(value, p - eye) - place * weight_of(p);
    }
};

/// By how much the planes of a view may lie aside: near and far in depth, the window's sides in its units.
struct PlaneSlack {
    double near, far, u, v;
};

template <class Number>
std::vector<CutPlane<Number>> cut_planes(const Camera& c, const Window& window, const PlaneSlack& slack) {
    const Vector3<Number> eye = exactly<Number>(glm::dvec3(c.eye_world)), back = exactly<Number>(c.back),
                          depth = Number(-1) * back, zero = Number(0) * back,
                          u = exactly<Number>(c.right) + Number(c.shear.x) * back,
                          v = exactly<Number>(c.up) + Number(c.shear.y) * back;
    const bool perspective = c.projection == Projection::perspective;
    const Vector3<Number>& divisor = perspective ? depth : zero;
    std::vector<CutPlane<Number>> planes;
    const auto add = [&](const Vector3<Number>& value, double place, double aside) {
        planes.push_back({eye, value, zero, Number(1), place - aside, place + aside});
    };
    const auto add_side = [&](const Vector3<Number>& value, double place, double aside) {
        planes.push_back({eye, value, divisor, Number(perspective ? 0 : 1), place - aside, place + aside});
    };
    add(depth, c.near_depth, slack.near);
    if (std::isfinite(c.far_depth)) add(back, -c.far_depth, slack.far);
    add_side(u, window.left, slack.u);
    add_side(Number(-1) * u, -window.right, slack.u);
    add_side(v, window.bottom, slack.v);
    add_side(Number(-1) * v, -window.top, slack.v);
    return planes;
}

/// Does the test hold for what is left of the triangle, somewhere in the planes' slack? It is given what the
/// planes leave at both ends of one step of each.
template <class Number, class Test>
bool any_cut(const PolygonWorld<Number>& triangle, std::span<const CutPlane<Number>> planes,
             const std::vector<PolygonWorld<Number>>& polygons, const Test& test) {
    if (planes.empty()) return test(polygons);
    const CutPlane<Number>& plane = planes.front();
    if (std::ranges::all_of(triangle, [&](const auto& p) { return plane.leaves(p); }))
        return any_cut(triangle, planes.subspan(1), polygons, test);
    const std::vector<Number> steps = plane.steps(triangle);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        std::vector<PolygonWorld<Number>> left;
        for (const auto& polygon : polygons) {
            left.push_back(plane.left_of(polygon, steps[i], plane.is_known()));
            if (!plane.is_known()) left.push_back(plane.left_of(polygon, steps[i + 1], true));
        }
        if (any_cut(triangle, planes.subspan(1), left, test)) return true;
    }
    return false;
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
