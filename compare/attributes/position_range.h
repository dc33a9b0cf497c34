/// Where a position may lie: along and across the pixel's view ray (docs/bounds.md, "Attributes").
#pragma once

#include <optional>
#include <vector>

#include "compare/bounds/triangle_extent.h"
#include "compare/bounds/view_ray.h"
#include "math/interval.h"
#include "math/rational.h"
#include "math/sign.h"

namespace zproof {

template <class Number>
struct PositionLimits {
    double half_side;                       ///< of the square in which it is seen, px
    Vector3<double> slack;                  ///< what arithmetic may do to its coordinates
    std::optional<Number> least, greatest;  ///< its depth, before that
};

/// Holds the points p with normal . (p - origin of the ray) + offset >= 0.
template <class Number>
struct HalfSpace {
    Vector3<Number> normal;
    Number offset;

    Number at(const Vector3<Number>& from_origin) const { return dot(normal, from_origin) + offset; }
};

template <class Number>
struct PositionRange {
    std::vector<HalfSpace<Number>> across, along;
};

/// A point of camera depth t that is seen at (x, y) px is origin + t direction + X step_x + Y step_y, with
/// X = t x for perspective and X = x for parallel projections. Cramer's rule gives each, times the
/// determinant.
template <class Number>
PositionRange<Number> position_range(const ViewRay<Number>& ray, const PositionLimits<Number>& limits) {
    const Vector3<Number>&d = ray.direction, &sx = ray.step_x, &sy = ray.step_y;
    const Number minus(-1), side(sign(dot(cross(sx, sy), d))), h(limits.half_side);
    const Vector3<Number> along = side * cross(sx, sy);
    const Number determinant = dot(along, d);
    const auto moved = [&](const Vector3<Number>& normal) {
        return Number(magnitude(normal.x) * Number(limits.slack.x) +
                      magnitude(normal.y) * Number(limits.slack.y) +
                      magnitude(normal.z) * Number(limits.slack.z));
    };
    PositionRange<Number> range;
    for (const Vector3<Number>& across : {side * cross(sy, d), side * cross(d, sx)})
        for (const Vector3<Number>& outwards : {across, minus * across}) {
            if (ray.projection == Projection::perspective)
                range.across.push_back({h * along - outwards, h * moved(along) + moved(outwards)});
            else
                range.across.push_back({minus * outwards, h * determinant + moved(outwards)});
        }
    if (limits.least) range.along.push_back({along, moved(along) - *limits.least * determinant});
    if (limits.greatest)
        range.along.push_back({minus * along, moved(along) + *limits.greatest * determinant});
    return range;
}

}  // namespace zproof
