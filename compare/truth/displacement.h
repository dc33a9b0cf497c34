/// How much of its bound a lawful answer needs: the tightness of eps, seen where edges decide.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/truth/estimate.h"

namespace zproof {

/// Displacements are told in so many steps of eps.
inline constexpr int displacement_steps = 1024;

/// Half the side of the least square that is asked about: what is seen there needs no displacement.
constexpr double least_px(double eps_px) { return eps_px / displacement_steps; }

/// The least half-side of a square around the centre in which the answer is seen, over eps_px of the
/// neighbourhood; multiples of 1/1024, rounded down, so never 1 for an answer that is lawful by place.
/// Nothing where not even 1/1024 is needed: the answer is right at the centre. An estimate in double, for
/// statistics; it decides nothing (docs/bounds.md, "Is the bound tight?").
///
/// For a triangle that misses the centre this is how far its corners must have moved; for one that others
/// hide there, or for background, how far those others must have moved aside.
std::optional<double> displacement_over_eps(Estimate& estimate);

/// The same where is_seen_within(half_side_px) says whether it is. What is seen in a square is seen in every
/// larger one: by ever larger strides from the likely half-side, where one is given, and then by bisection.
template <class IsSeenWithin>
std::optional<double> least_step(double eps_px, std::optional<double> likely_px,
                                 const IsSeenWithin& is_seen_within) {
    const auto is_seen = [&](int step) { return is_seen_within(eps_px * step / displacement_steps); };
    if (is_seen(1)) return std::nullopt;
    int too_small = 1, enough = displacement_steps;
    const double likely_step = likely_px.value_or(eps_px / 2) / eps_px * displacement_steps;
    int step = int(std::min(std::max(too_small + 1.0, std::ceil(likely_step)), enough - 1.0));  // of NaN, too
    int stride = likely_px ? 1 : displacement_steps;
    while (enough - too_small > 1) {
        const bool seen = is_seen(step);
        (seen ? enough : too_small) = step;
        step += seen ? -stride : stride;
        stride *= 2;
        if (step <= too_small || step >= enough) step = (too_small + enough) / 2;
    }
    return double(too_small) / displacement_steps;
}

}  // namespace zproof
