/// The words of compare/truth/standing.h spelled out over any set of answers, long ways and all.
#pragma once

#include "compare/truth/admissible.h"
#include "compare/truth/standing.h"

namespace zproof {

template <class Set>
Standing word_for(Set& set, std::size_t count, std::optional<std::size_t> index) {
    constexpr Rules by_place{DepthRule::strict, EdgeRule::watertight};
    constexpr Rules by_depth{DepthRule::bounded, EdgeRule::watertight};
    constexpr Rules by_crack{DepthRule::bounded, EdgeRule::separate};
    bool clipped = false;
    for (std::size_t i = 0; i < count; ++i) clipped = clipped || set.is_clipped(i);
    const Standing seen = clipped ? Standing::clipped : Standing::visible;
    if (!index) {
        if (set.holds_background(EdgeRule::watertight)) return seen;
        return set.holds_background(EdgeRule::separate) ? Standing::through_a_crack : Standing::hole;
    }
    if (!set.reaches(*index)) return Standing::outside;
    if (set.is_visible(*index) || set.holds(*index, by_place)) return seen;
    if (set.holds(*index, by_depth)) return Standing::tied;
    return set.holds(*index, by_crack) ? Standing::through_a_crack : Standing::hidden;
}

}  // namespace zproof
