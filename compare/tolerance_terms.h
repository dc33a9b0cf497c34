/// From the laws of a triangle's depth to its tolerance in a part of the image (docs/truth.md, "Tolerances").
/// In double, or four at a time.
#pragma once

#include <limits>

#include "compare/depth_terms.h"
#include "compare/depth_tolerance.h"
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

/// So far from their corners all places lie, or else are left out.
template <class Number>
Number distance(const Range<Number>& w, const Range<Number>& corners, Reach reach) {
    if (reach == Reach::but_corners) return (corners.most - corners.least) / 4.0;
    return smaller(w.least - corners.least, corners.most - w.most);
}

/// See docs/truth.md.
template <class Number>
typename DepthToleranceOf<Number>::Bound bound_of(const DepthLawOf<Number>& law, const Range<Number>& w,
                                                  const Number& shift, Projection projection) {
    constexpr double u = unit_roundoff_float64, infinite = std::numeric_limits<double>::infinity();
    const Number one = everywhere<Number>(1), none = everywhere<Number>(0);
    if (projection == Projection::parallel) {
        const auto is_covered = (law.plane_offset == 0.0) & (law.per == 0.0) & (law.relative < infinite);
        const Number r = smaller(law.relative, one);
        const Number room = shift * (1.0 - r) + r * w.least + law.absolute;
        const Number lawful = 1.0 - (law.own_error + 12 * u * w.most) / room;
        return {room, is_covered ? lawful : none};
    }
    const Number most_r = compounded(law.depth_factor + law.plane_offset / w.least);
    const Number least_r = smaller(law.depth_factor + law.plane_offset / w.most, one);
    const Number room =
        shift * (1.0 - smaller(most_r, one)) / (w.most + shift) + least_r + law.absolute * w.least;
    const Number lawful = 1.0 - (4.5 * law.own_error / w.least + 12 * u) / room;
    return {room, most_r < infinite ? lawful : none};
}

}  // namespace detail

/// Where nothing is certain it holds nowhere: `least` is then larger than `most`.
template <class Number>
DepthToleranceOf<Number> tolerance_of(const DepthLawOf<Number>& candidate,
                                      const DepthLawOf<Number>& reference, Projection projection,
                                      const PixelBox& part, Reach reach) {
    using namespace detail;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool perspective = projection == Projection::perspective;
    const double sign = perspective ? 1 : -1;
    const Number one = everywhere<Number>(1), none = everywhere<Number>(0);
    DepthToleranceOf<Number> t{};
    t.w_per_x = sign * candidate.nearness_per_x;
    t.w_per_y = sign * candidate.nearness_per_y;
    t.w_offset = sign * candidate.nearness_offset;
    const Range<Number> corners{(perspective ? candidate.least : 1.0 / candidate.highest) * (1 - widening),
                                (perspective ? candidate.highest : 1.0 / candidate.least) * (1 + widening)};
    const Range<Number> w = range_of(t, corners, part);
    const Number away = distance(w, corners, reach);
    const Number our_shift = shift_at(candidate, w.least), their_shift = shift_at(reference, w.least);
    const auto we_keep = keeps_to_corners(candidate), they_keep = keeps_to_corners(reference);
    const Number ours = we_keep ? smaller(our_shift, away) : our_shift,
                 theirs = they_keep ? smaller(their_shift, away) : their_shift;
    t.largest = 0.5 * (perspective ? one : w.least);
    t.unsure = 8 * widening * (perspective ? one : w.most);
    t.candidate = bound_of(candidate, w, ours, projection);
    t.reference = bound_of(reference, w, theirs, projection);
    const auto holds = (w.least > 0.0) & (w.least <= w.most) & (w.most < infinite) &
                       (t.candidate.lawful > 0.0) & (t.reference.lawful > 0.0);
    const Number kept_out = larger(we_keep ? ours : none, they_keep ? theirs : none),
                 left_out = reach == Reach::all ? none : kept_out;
    const Number least = larger(w.least, corners.least + left_out),
                 most = smaller(w.most, corners.most - left_out);
    t.least = holds ? least : everywhere<Number>(infinite);
    t.most = holds ? most : everywhere<Number>(-infinite);
    return t;
}

}  // namespace zproof
