/// From the laws of a triangle's depth to its tolerance in a part of the image (docs/truth.md, "Tolerances").
/// In double, or four at a time.
#pragma once

#include <limits>

#include "compare/bounds/depth_terms.h"
#include "compare/bounds/depth_tolerance.h"
#include "math/rounding.h"

namespace zproof {

namespace detail {

/// By what share places are let beyond their corners': 1 / (1 / depth) need not be depth, and nearness is
/// rounded.
inline constexpr double widening = 128 * unit_roundoff_float64;

/// Of w.
template <class Number>
struct Range {
    Number least, most;
};

/// What displacement does to w there.
template <class Number>
Number shift_at(const DepthLawOf<Number>& law, const Number& w) {
    return smaller(law.most, (law.base + law.per * w) * law.amplification) * law.gradient +
           law.nearness_error;
}

template <class Number>
auto keeps_to_corners(const DepthLawOf<Number>& law) {
    return absolute(law.farthest) < std::numeric_limits<double>::infinity();
}

/// In a part of the image, and between its corners.
template <class Number>
Range<Number> range_of(const DepthToleranceOf<Number>& t, const Range<Number>& corners,
                       const PixelBox& part) {
    const Number left = t.w_per_x * double(part.left), right = t.w_per_x * double(part.right - 1);
    const Number top = t.w_per_y * double(part.top), bottom = t.w_per_y * double(part.bottom - 1);
    return {larger(corners.least, smaller(left, right) + smaller(top, bottom) + t.w_offset),
            smaller(corners.most, larger(left, right) + larger(top, bottom) + t.w_offset)};
}

/// What displacement does to the room of one renderer's errors, which is at_corners + per_shift * shift.
template <class Number>
struct RoomTerms {
    Number at_corners, per_shift, own;
};

/// With no more displacement than comes to `shift` in w; see docs/truth.md.
template <class Number>
RoomTerms<Number> room_terms(const DepthLawOf<Number>& law, const Range<Number>& w, const Number& shift,
                             Projection projection) {
    constexpr double u = unit_roundoff_float64;
    const Number one = everywhere<Number>(1),
                 infinite = everywhere<Number>(std::numeric_limits<double>::infinity());
    if (projection == Projection::parallel) {
        const auto is_covered = (law.plane_offset == 0.0) & (law.per == 0.0) & (law.relative < infinite);
        const Number r = smaller(law.relative, one), own = law.own_error + 12 * u * w.most;
        return {r * w.least + law.absolute, 1.0 - r, is_covered ? own : infinite};
    }
    const Number most_r = compounded(law.depth_factor + law.plane_offset / w.least);
    const Number least_r = smaller(law.depth_factor + law.plane_offset / w.most, one);
    const Number own = 4.5 * law.own_error / w.least + 12 * u;
    return {least_r + law.absolute * w.least, (1.0 - smaller(most_r, one)) / (w.most + shift),
            most_r < infinite ? own : infinite};
}

template <class Number>
typename CornerToleranceOf<Number>::Bound next_to_corners(const DepthLawOf<Number>& law,
                                                          const Range<Number>& w,
                                                          const Range<Number>& corners,
                                                          Projection projection) {
    const auto keeps = keeps_to_corners(law);
    const Number any = shift_at(law, w.least), kept = smaller(any, (corners.most - corners.least) / 4.0);
    const Number shift = keeps ? kept : any, none = everywhere<Number>(0);
    const RoomTerms<Number> terms = room_terms(law, w, shift, projection);
    return {.at_corners = keeps ? terms.at_corners : terms.at_corners + terms.per_shift * shift,
            .per_shift = keeps ? terms.per_shift : none,
            .shift = keeps ? shift : none,
            .own = terms.own};
}

/// Far from the corners.
template <class Number>
typename DepthToleranceOf<Number>::Bound far_off(const typename CornerToleranceOf<Number>::Bound& bound,
                                                 const Number& unsure, const Number& largest) {
    const Number room = bound.at_corners + bound.per_shift * bound.shift;
    return {room, smaller(room - bound.own - unsure, largest)};
}

}  // namespace detail

template <class Number>
TolerancesOf<Number> tolerances_of(const DepthLawOf<Number>& candidate, const DepthLawOf<Number>& reference,
                                   Projection projection, const PixelBox& part) {
    using namespace detail;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool perspective = projection == Projection::perspective;
    const double sign = perspective ? 1 : -1;
    const Number one = everywhere<Number>(1), nothing = everywhere<Number>(infinite);
    DepthToleranceOf<Number> t{};
    CornerToleranceOf<Number> c{};
    t.w_per_x = sign * candidate.nearness_per_x;
    t.w_per_y = sign * candidate.nearness_per_y;
    t.w_offset = sign * candidate.nearness_offset;
    const Range<Number> corners{(perspective ? candidate.least : 1.0 / candidate.highest) * (1 - widening),
                                (perspective ? candidate.highest : 1.0 / candidate.least) * (1 + widening)};
    const Range<Number> w = range_of(t, corners, part);
    t.unsure = 8 * widening * (perspective ? one : w.most);
    c.largest = 0.5 * (perspective ? one : w.least);
    c.candidate = next_to_corners(candidate, w, corners, projection);
    c.reference = next_to_corners(reference, w, corners, projection);
    t.candidate = far_off(c.candidate, t.unsure, c.largest);
    t.reference = far_off(c.reference, t.unsure, c.largest);
    const auto holds = (w.least > 0.0) & (w.least <= w.most) & (w.most < infinite) &
                       (c.candidate.own < t.candidate.room) & (c.reference.own < t.reference.room);
    c.least = holds ? w.least : nothing;
    c.most = holds ? w.most : -nothing;
    c.corner_least = corners.least, c.corner_most = corners.most;
    const Number away = larger(c.candidate.shift, c.reference.shift);
    t.least = larger(c.least, corners.least + away);
    t.most = smaller(c.most, corners.most - away);
    return {t, c};
}

}  // namespace zproof
