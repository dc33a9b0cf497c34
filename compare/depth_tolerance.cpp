#include "compare/depth_tolerance.h"

#include <algorithm>
#include <cmath>

#include "compare/depth_terms.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double u = unit_roundoff_float64;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// By what share places are let beyond their corners': 1 / (1 / depth) need not be depth, and nearness is
/// rounded.
constexpr double widening = 128 * u;

/// Of w.
struct Range {
    double least, most;
};

/// What displacement does to w there.
double shift_at(const DepthLaw& law, double w) {
    return std::min(law.most, (law.base + law.per * w) * law.amplification) * law.gradient +
           law.nearness_error;
}

bool keeps_to_corners(const DepthLaw& law) { return !std::isinf(law.farthest); }

/// In a part of the image, and between its corners.
Range range_of(const DepthTolerance& t, const Range& corners, const PixelBox& part) {
    const double left = t.w_per_x * part.left, right = t.w_per_x * (part.right - 1);
    const double top = t.w_per_y * part.top, bottom = t.w_per_y * (part.bottom - 1);
    return {std::max(corners.least, std::min(left, right) + std::min(top, bottom) + t.w_offset),
            std::min(corners.most, std::max(left, right) + std::max(top, bottom) + t.w_offset)};
}

/// So far from their corners all places lie, or else are left out.
double distance(const Range& w, const Range& corners, Reach reach) {
    if (reach == Reach::but_corners) return (corners.most - corners.least) / 4;
    return std::min(w.least - corners.least, corners.most - w.most);
}

/// See docs/truth.md.
DepthTolerance::Bound bound_of(const DepthLaw& law, const Range& w, double shift, Projection projection) {
    if (projection == Projection::parallel) {
        const bool is_covered = law.plane_offset == 0 && law.per == 0 && law.relative < infinite;
        const double r = std::min(law.relative, 1.0);
        const double room = shift * (1 - r) + r * w.least + law.absolute;
        return {room, is_covered ? 1 - (law.own_error + 12 * u * w.most) / room : 0};
    }
    const double most_r = compounded(law.depth_factor + law.plane_offset / w.least);
    const double least_r = std::min(law.depth_factor + law.plane_offset / w.most, 1.0);
    const double room =
        shift * (1 - std::min(most_r, 1.0)) / (w.most + shift) + least_r + law.absolute * w.least;
    return {room, most_r < infinite ? 1 - (4.5 * law.own_error / w.least + 12 * u) / room : 0};
}

}  // namespace

DepthTolerance tolerance_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                            const PixelBox& part, Reach reach) {
    DepthTolerance t{};
    const bool perspective = projection == Projection::perspective;
    const double sign = perspective ? 1 : -1;
    t.w_per_x = sign * candidate.nearness_per_x;
    t.w_per_y = sign * candidate.nearness_per_y;
    t.w_offset = sign * candidate.nearness_offset;
    const Range corners{(perspective ? candidate.least : 1 / candidate.highest) * (1 - widening),
                        (perspective ? candidate.highest : 1 / candidate.least) * (1 + widening)};
    const Range w = range_of(t, corners, part);
    if (!(w.least > 0 && w.least <= w.most && w.most < infinite)) return t;
    const double away = distance(w, corners, reach);
    const auto shift_of = [&](const DepthLaw& law) {
        const double shift = shift_at(law, w.least);
        return keeps_to_corners(law) ? std::min(shift, away) : shift;
    };
    const double ours = shift_of(candidate), theirs = shift_of(reference);
    const double left_out = reach == Reach::all ? 0
                                                : std::max(keeps_to_corners(candidate) ? ours : 0,
                                                           keeps_to_corners(reference) ? theirs : 0);
    t.largest = 0.5 * (perspective ? 1 : w.least);
    t.unsure = 8 * widening * (perspective ? 1 : w.most);
    t.candidate = bound_of(candidate, w, ours, projection);
    t.reference = bound_of(reference, w, theirs, projection);
    if (!(t.candidate.lawful > 0 && t.reference.lawful > 0)) return t;
    t.least = std::max(w.least, corners.least + left_out);
    t.most = std::min(w.most, corners.most - left_out);
    return t;
}

}  // namespace zproof
