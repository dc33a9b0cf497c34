#include "compare/truth/standing.h"

#include <algorithm>

#include "compare/truth/admissible.h"
#include "compare/truth/plain_case.h"
#include "math/interval.h"
#include "math/lazy_rational.h"

namespace zproof {

namespace {

constexpr Rules by_depth{DepthRule::bounded, EdgeRule::watertight};
constexpr Rules by_crack{DepthRule::bounded, EdgeRule::separate};

template <class Number>
bool any_clipped(AdmissibleSet<Number>& set, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (set.is_clipped(i)) return true;
    return false;
}

template <class Number>
Standing standing_of_background(AdmissibleSet<Number>& set, size_t count) {
    if (set.holds_background(EdgeRule::watertight))
        return any_clipped(set, count) ? Standing::clipped : Standing::visible;
    return set.holds_background(EdgeRule::separate) ? Standing::through_a_crack : Standing::hole;
}

template <class Number>
Standing standing_of_triangle(AdmissibleSet<Number>& set, size_t index, size_t count) {
    if (!set.reaches(index)) return Standing::outside;
    if (set.is_seen(index)) return any_clipped(set, count) ? Standing::clipped : Standing::visible;
    if (set.holds(index, by_depth)) return Standing::tied;
    return set.holds(index, by_crack) ? Standing::through_a_crack : Standing::hidden;
}

template <class Number>
Standing standing_in(const Neighbourhood& around, PrimitiveId answer, CoplanarMemory& memory) {
    AdmissibleSet<Number> set(around, memory);
    const size_t count = around.neighbours.size();
    if (answer == PrimitiveId::none) return standing_of_background(set, count);
    const std::optional<size_t> index = around.index_of(answer);
    return index ? standing_of_triangle(set, *index, count) : Standing::outside;
}

}  // namespace

Decision decide(const Neighbourhood& around, PrimitiveId answer) {
    CoplanarMemory memory(16);
    return decide(around, answer, memory);
}

Decision decide(const Neighbourhood& around, PrimitiveId answer, CoplanarMemory& memory) {
    if (const auto plain = standing_without_edges(around, answer, memory)) return {*plain, false};
    try {
        return {standing_in<Interval>(around, answer, memory), false};
    } catch (const UndecidedSign&) {
        return {standing_in<LazyRational>(around, answer, memory), true};
    }
}

PixelClass class_of(Standing candidate, Standing reference) {
    switch (candidate) {
        case Standing::hole:
            return PixelClass::hole;
        case Standing::outside:
            return PixelClass::outside;
        case Standing::hidden:
            return PixelClass::hidden;
        default:
            break;
    }
    if (!is_lawful(reference)) return PixelClass::reference_wrong;
    switch (std::max(candidate, reference)) {
        case Standing::through_a_crack:
            return PixelClass::abutting_edges;
        case Standing::tied:
            return PixelClass::depth_tie;
        case Standing::clipped:
            return PixelClass::clip;
        default:
            return PixelClass::edge;
    }
}

}  // namespace zproof
