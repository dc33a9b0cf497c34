#include "compare/depth_estimate.h"

#include <algorithm>
#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double u = unit_roundoff_float64, v = unit_roundoff_float32;

/// By what share places are let beyond their corners': 1 / (1 / depth) need not be depth, and nearness is
/// rounded.
constexpr double widening = 128 * u;

/// Numbers far from where single precision ends, so that no sum or product of a few of them leaves it.
constexpr double smallest = 0x1p-30, largest = 0x1p30;

/// Can a place be that near that no depth is left?
bool may_reach_zero(const DepthLaw& law, const DepthEstimate& plane, Projection projection) {
    const double per_depth =
        projection == Projection::perspective ? 2 * plane.most : 4 / plane.least;  // at the nearest place
    return !(law.absolute * per_depth < 0.5);
}

/// The folded law, and whether it is what the derivation in docs/truth.md asks for.
DepthEstimate::Bound bound_of(const DepthLaw& law, const DepthEstimate& plane, Projection projection) {
    const bool perspective = projection == Projection::perspective;
    const double reach = law.amplification * law.gradient;
    const double most_shift = law.most * law.gradient;
    // relative errors add up to factor + offset / w and are then compounded; how much that varies
    const double largest_sum = law.depth_factor + law.plane_offset / plane.least;
    const double variation = law.plane_offset / plane.least - law.plane_offset / plane.most;
    const double factor = perspective ? law.depth_factor / (1 - largest_sum) : law.relative;
    const double unsure = bins_per_ratio * (32 * v + 2 * variation) + 160 * widening / factor;
    const double own_error = (perspective ? 2 : 1) * law.own_error / plane.least;
    const double margin = 3 * (own_error + 10 * u) / factor;
    const bool is_common = perspective || (law.plane_offset == 0 && law.per == 0);
    const bool is_moderate = largest_sum < 0.5 && factor >= smallest && factor < 0.25 &&
                             law.per * reach < largest && law.base * reach < largest &&
                             most_shift + law.nearness_error <= plane.least / 2;
    const bool is_usable = is_common && is_moderate && unsure < 0.125 && margin < 0.25 &&
                           !may_reach_zero(law, plane, projection);
    return {.shift_base = float(law.base * reach),
            .most_shift = float(most_shift),
            .nearness_error = float(law.nearness_error),
            .beyond = std::isinf(law.farthest) ? float(largest) : 0.0f,
            .factor = float(factor),
            .absolute = float(law.absolute),
            .unsure = float(unsure),
            .top = is_usable ? float(bins_per_ratio * (1 - margin) - unsure) : -1.0f,
            .shift_per = float(law.per * reach),
            .plane_offset = float(law.plane_offset / (1 - largest_sum))};
}

/// The least that a place is displaced by, where nothing holds it back.
double least_shift(const DepthEstimate::Bound& bound, const DepthEstimate& plane) {
    if (bound.beyond == 0) return 0;
    const double varying = double{bound.shift_base} + double{bound.shift_per} * plane.least;
    return std::min(varying, double{bound.most_shift}) + double{bound.nearness_error};
}

/// See docs/truth.md.
DepthEstimate::Quiet quiet_of(const DepthEstimate::Bound& bound, const DepthEstimate& plane,
                              Projection projection, float known_largest) {
    const double ceiling = std::min({1.0f, bound.top, known_largest});
    const double share = (ceiling - double{bound.unsure}) / bins_per_ratio * (1 - 0x1p-16);
    if (!(share > 0)) return {};
    const double shift = least_shift(bound, plane), factor = bound.factor;
    const double room = projection == Projection::perspective ? shift + double{bound.plane_offset}
                                                              : shift * (1 - factor) + double{bound.absolute};
    return {.shift = float(shift), .slope = float(share * factor), .room = float(share * room)};
}

}  // namespace

DepthEstimate estimate_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                          const KnownLargest& known) {
    DepthEstimate t{};
    const bool perspective = projection == Projection::perspective;
    const double sign = perspective ? 1 : -1;
    t.w_per_x = sign * candidate.nearness_per_x;
    t.w_per_y = sign * candidate.nearness_per_y;
    t.w_offset = sign * candidate.nearness_offset;
    const double nearest = 1 / candidate.highest, farthest = 1 / candidate.least;
    t.least = perspective ? candidate.least : nearest;
    t.most = perspective ? candidate.highest : farthest;
    t.least *= 1 - widening, t.most *= 1 + widening;
    if (!(t.least >= smallest && t.most <= largest)) return t;
    t.candidate = bound_of(candidate, t, projection);
    t.reference = bound_of(reference, t, projection);
    t.is_usable = t.candidate.top > 0 && t.reference.top > 0;
    if (!t.is_usable) t.candidate.top = t.reference.top = -1;
    t.candidate_quiet = quiet_of(t.candidate, t, projection, known.candidate);
    t.reference_quiet = quiet_of(t.reference, t, projection, known.reference);
    return t;
}

}  // namespace zproof
