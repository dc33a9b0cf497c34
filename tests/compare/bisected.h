/// How far an answer must be displaced, the plain way: by bisection, and polygons in double alone.
#pragma once

#include <optional>

#include "compare/admissible/admissible_set.h"
#include "compare/admissible/conservative.h"
#include "compare/admissible/displacement.h"

namespace zproof {

/// What displacement_of() should find. A triangle must be a neighbour.
inline std::optional<double> bisected_displacement(const Neighbourhood& around, PrimitiveId answer) {
    AdmissibleSet<double> set(around);
    const auto is_seen = [&](int step) {
        set.set_half_side(around.eps_px * step / displacement_steps);
        return answer == PrimitiveId::none ? set.holds_background(EdgeRule::watertight)
                                           : set.is_seen(*around.index_of(answer));
    };
    if (is_seen(1)) return std::nullopt;
    int too_small = 1, enough = displacement_steps;
    while (enough - too_small > 1) {
        const int middle = (too_small + enough) / 2;
        (is_seen(middle) ? enough : too_small) = middle;
    }
    set.set_half_side(around.eps_px);
    if (enough == displacement_steps && answer != PrimitiveId::none && !set.reaches(*around.index_of(answer)))
        return std::nullopt;  // shown by rounding, wherever it lies
    return double(too_small) / displacement_steps;
}

}  // namespace zproof
