/// What an interpolated value may be around a pixel: attribute = sum w_i a_i / sum w_i, where the weights w_i
/// are the edge functionals of the triangle's image. Both sums are affine, so their quotient is extreme at
/// the corners of a convex polygon.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "compare/bounds/triangle_image.h"
#include "math/interval.h"

namespace zproof {

/// The weights of the three corners' values at one place; their sum is above 0.
template <class Number>
struct Weights {
    std::array<Number, 3> of_corner;
    Number sum;

    Number blend(const std::array<double, 3>& at_corners) const {
        return (of_corner[0] * Number(at_corners[0]) + of_corner[1] * Number(at_corners[1]) +
                of_corner[2] * Number(at_corners[2])) /
               sum;
    }
};

template <class Number>
Weights<Number> weights_at(const TriangleImage<Number>& image, const Number& x, const Number& y) {
    const std::array<Number, 3> w{image.edge[0].at(x, y), image.edge[1].at(x, y), image.edge[2].at(x, y)};
    return {w, w[0] + w[1] + w[2]};
}

/// Where in the square a renderer may have taken its values.
enum class SampledPlaces {
    on_triangle,  ///< on the triangle
    anywhere,     ///< on its plane
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

inline Interval least(const Interval& a, const Interval& b) {
    return {std::min(a.low(), b.low()), std::min(a.high(), b.high())};
}
template <class Number>
Number least(const Number& a, const Number& b) {
    return b < a ? b : a;
}
template <class Number>
Number greatest(const Number& a, const Number& b) {
    return -least(Number(-a), Number(-b));
}

}  // namespace detail

/// The places at which values are extreme: the corners of the square, or of its part within the triangle;
/// none where the triangle does not meet the square. The sum of weights must be above 0 at all of them. On
/// the triangle it is.
template <class Number>
std::vector<Weights<Number>> extreme_places(const TriangleImage<Number>& image, double half_side,
                                            SampledPlaces sampled) {
    const Number h(half_side), l(-half_side);
    detail::Points<Number> points{{l, l}, {h, l}, {h, h}, {l, h}};
    if (sampled == SampledPlaces::on_triangle)
        for (const Affine<Number>& edge : image.edge) points = detail::part_inside(points, edge);
    std::vector<Weights<Number>> places;
    for (const auto& [x, y] : points) places.push_back(weights_at(image, x, y));
    return places;
}

template <class Number>
struct ValueRange {
    Number low, high;
};

/// The least and the greatest value at these places, of which there must be some.
template <class Number>
ValueRange<Number> range_of(const std::vector<Weights<Number>>& places,
                            const std::array<double, 3>& at_corners) {
    ValueRange<Number> range{places.front().blend(at_corners), places.front().blend(at_corners)};
    for (const Weights<Number>& place : places) {
        const Number value = place.blend(at_corners);
        range.low = detail::least(range.low, value);
        range.high = detail::greatest(range.high, value);
    }
    return range;
}

}  // namespace zproof
