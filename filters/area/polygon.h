/// Convex polygons of the image plane and what a straight line makes of them.
///
/// Offsets from some origin, pixels, y down. Any number type: double for pictures, Rational for tests.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>

#include "math/affine.h"

namespace zproof::oracle::area {

template <class Number>
struct Point {
    Number x, y;
};

/// Corners in order, either way round; fewer than three enclose nothing.
inline constexpr std::size_t most_corners = 48;
template <class Number>
using Polygon = boost::container::static_vector<Point<Number>, most_corners>;

/// The points where a polygon's boundary crosses a line.
template <class Number>
using Crossings = boost::container::static_vector<Point<Number>, 2>;

template <class Number>
struct Halves {
    Polygon<Number> inside, outside;  ///< f >= 0, f <= 0
    Crossings<Number> crossings;      ///< points of the boundary with f = 0
};

/// The point where f vanishes between a point with value at_p and another with value at_q, of opposite signs.
/// Symmetric in p and q, so that neighbours who share the edge cut it at the same place.
template <class Number>
Point<Number> crossing(const Point<Number>& p, const Number& at_p, const Point<Number>& q,
                       const Number& at_q) {
    const Number span = at_p - at_q;
    return {(at_p * q.x - at_q * p.x) / span, (at_p * q.y - at_q * p.y) / span};
}

/// Cuts along f = 0. A corner on the line belongs to both halves.
template <class Number>
Halves<Number> cut(const Polygon<Number>& polygon, const Affine<Number>& f) {
    Halves<Number> halves;
    if (polygon.empty()) return halves;
    const auto keep_crossing = [&](const Point<Number>& p) {
        if (halves.crossings.size() < 2) halves.crossings.push_back(p);
    };
    const Point<Number>* from = &polygon.back();
    Number at_from = f.at(from->x, from->y);
    for (const Point<Number>& to : polygon) {
        const Number at_to = f.at(to.x, to.y);
        if ((at_from > 0 && at_to < 0) || (at_from < 0 && at_to > 0)) {
            const Point<Number> between = crossing(*from, at_from, to, at_to);
            halves.inside.push_back(between);
            halves.outside.push_back(between);
            keep_crossing(between);
        }
        if (!(at_to < 0)) halves.inside.push_back(to);
        if (!(at_to > 0)) halves.outside.push_back(to);
        if (at_to == 0) keep_crossing(to);
        from = &to;
        at_from = at_to;
    }
    return halves;
}

/// The area in px^2; never negative.
template <class Number>
Number area_of(const Polygon<Number>& polygon) {
    Number twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Point<Number>&o = polygon[0], &p = polygon[i - 1], &q = polygon[i];
        twice = twice + ((p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x));
    }
    return (twice < 0 ? Number(-twice) : twice) / Number(2);
}

/// The square |x|, |y| <= half_side.
template <class Number>
Polygon<Number> square(const Number& half_side) {
    const Number h = half_side, l = -half_side;
    return {{l, l}, {h, l}, {h, h}, {l, h}};
}

}  // namespace zproof::oracle::area
