/// What an interpolated value may be around a pixel: attribute = sum w_i a_i / sum w_i, where the weights w_i
/// are the edge functionals of the triangle's image. Both sums are affine, so their quotient is extreme at
/// the corners of a convex polygon.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "compare/bounds/triangle_image.h"
#include "math/interval.h"

namespace zproof {

/// The weights of the three corners' values at one place; their sum is above 0.
template <class Number>
struct Weights {
    std::array<Number, 3> of_corner;
    Number sum;
};

namespace detail {

template <class Number>
using Points = std::vector<std::array<Number, 2>>;

/// The part of a convex polygon where f >= 0.
template <class Number>
Points<Number> part_inside(const Points<Number>& polygon, const Affine<Number>& f) {
    Points<Number> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const Number fp = f.at(p[0], p[1]), fq = f.at(q[0], q[1]);
        const int sp = sign(fp), sq = sign(fq);
        if (sp >= 0) part.push_back(p);
        if (sp * sq >= 0) continue;
        const Number t = fp / (fp - fq);
        part.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
    return part;
}

}  // namespace detail

/// The places at which values are extreme: the corners of the square's part within the triangle, and the
/// centre. Those of the triangle where it does not meet the square.
template <class Number>
std::vector<Weights<Number>> extreme_places(const TriangleImage<Number>& image, double half_side) {
    const Number h(half_side), l(-half_side), zero(0), one(1);
    detail::Points<Number> points{{l, l}, {h, l}, {h, h}, {l, h}};
    for (const Affine<Number>& edge : image.edge) points = detail::part_inside(points, edge);
    std::vector<Weights<Number>> places;
    if (points.empty())
        places = {{{one, zero, zero}, one}, {{zero, one, zero}, one}, {{zero, zero, one}, one}};
    points.push_back({zero, zero});
    for (const auto& [x, y] : points) {
        const std::array<Number, 3> w{image.edge[0].at(x, y), image.edge[1].at(x, y), image.edge[2].at(x, y)};
        const Number sum = w[0] + w[1] + w[2];
        if (sign(sum) > 0) places.push_back({w, sum});
    }
    return places;
}

/// Is value + slack at least (at most, for side -1) the attribute at one of the places? Throws UndecidedSign
/// where that is not certain.
template <class Number>
bool is_not_beyond(std::span<const Weights<Number>> places, const std::array<double, 3>& at_corners,
                   double value, double slack, int side) {
    bool is_undecided = false;
    const Number limit = Number(value) + Number(side * slack);
    for (const Weights<Number>& w : places) try {
            const Number blended = w.of_corner[0] * Number(at_corners[0]) +
                                   w.of_corner[1] * Number(at_corners[1]) +
                                   w.of_corner[2] * Number(at_corners[2]);
            if (side * sign(limit * w.sum - blended) >= 0) return true;
        } catch (const UndecidedSign&) {
            is_undecided = true;
        }
    if (is_undecided) throw UndecidedSign{};
    return false;
}

}  // namespace zproof
