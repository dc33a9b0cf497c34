/// The words of compare/admissible/admissibility.h spelled out over any set of answers, long ways and all.
#pragma once

#include "compare/admissible/admissibility.h"
#include "compare/admissible/admissible_set.h"

namespace zproof {

template <class Set>
Admissibility word_for(Set& set, std::size_t count, std::optional<std::size_t> index) {
    constexpr Rules by_place{DepthRule::strict, EdgeRule::watertight};
    constexpr Rules by_depth{DepthRule::bounded, EdgeRule::watertight};
    constexpr Rules by_crack{DepthRule::bounded, EdgeRule::separate};
    bool clipped = false;
    for (std::size_t i = 0; i < count; ++i) clipped = clipped || set.is_clipped(i);
    const Admissibility seen = clipped ? Admissibility::clipped : Admissibility::visible;
    if (!index) {
        if (set.holds_background(EdgeRule::watertight)) return seen;
        return set.holds_background(EdgeRule::separate) ? Admissibility::through_a_crack
                                                        : Admissibility::hole;
    }
    if (!set.is_shown(*index)) return Admissibility::outside;
    if (set.is_visible(*index) || set.holds(*index, by_place)) return seen;
    if (set.holds(*index, by_depth)) return Admissibility::tied;
    return set.holds(*index, by_crack) ? Admissibility::through_a_crack : Admissibility::hidden;
}

}  // namespace zproof
