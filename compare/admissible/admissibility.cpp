#include "compare/admissible/admissibility.h"

#include <algorithm>
#include <stdexcept>

#include "compare/admissible/admissible_set.h"
#include "compare/admissible/conservative.h"
#include "math/interval.h"
#include "math/lazy_rational.h"

namespace zproof {

namespace {

constexpr Rules by_crack{DepthRule::bounded, EdgeRule::separate};

template <class Number>
bool any_clipped(AdmissibleSet<Number>& set, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (set.is_clipped(i)) return true;
    return false;
}

template <class Number>
Admissibility of_background(AdmissibleSet<Number>& set, size_t count) {
    if (set.holds_background(set.edge_rule()))
        return any_clipped(set, count) ? Admissibility::clipped : Admissibility::visible;
    return set.holds_background(EdgeRule::separate) ? Admissibility::through_a_crack : Admissibility::hole;
}

template <class Number>
Admissibility of_triangle(AdmissibleSet<Number>& set, size_t index, size_t count) {
    if (!set.is_shown(index)) return Admissibility::outside;
    if (set.is_seen(index)) return any_clipped(set, count) ? Admissibility::clipped : Admissibility::visible;
    if (set.holds(index, {DepthRule::bounded, set.edge_rule()})) return Admissibility::tied;
    return set.holds(index, by_crack) ? Admissibility::through_a_crack : Admissibility::hidden;
}

template <class Number>
Admissibility admissibility_in(AdmissibleSet<Number>& set, const Neighbourhood& around, PrimitiveId answer) {
    const size_t count = around.neighbours.size();
    try {
        if (answer == PrimitiveId::none) return of_background(set, count);
        const std::optional<size_t> index = around.index_of(answer);
        return index ? of_triangle(set, *index, count) : Admissibility::outside;
    } catch (const TooMuchWork&) {
        return Admissibility::undecidable;
    }
}

/// By intervals, then by rationals.
Decision decide_by_region(const Neighbourhood& around, PrimitiveId answer, CoplanarCache& coplanar) {
    AdmissibleSet<Interval> fast(around, coplanar);
    try {
        const Admissibility found = admissibility_in(fast, around, answer);
        return {found, false, around.eps_px, fast.work()};
    } catch (const UndecidedSign&) {
        AdmissibleSet<LazyRational> exact(around, coplanar);
        const Admissibility found = admissibility_in(exact, around, answer);
        return {found, true, around.eps_px, fast.work() + exact.work()};
    }
}

/// Do two corners of one stand where two of the other do?
bool share_an_edge(const Neighbour& a, const Neighbour& b) {
    return std::ranges::count_if(a.p_world, [&](const glm::vec3& p) {
               return std::ranges::find(b.p_world, p) != b.p_world.end();
           }) >= 2;
}

}  // namespace

Decision decide(const Neighbourhood& around, PrimitiveId answer, CoplanarCache& coplanar) {
    const double eps_px = around.eps_px;
    switch (ConservativeTest(around, answer, coplanar).finding()) {
        case ConservativeTest::Finding::visible:
            return {Admissibility::visible, false, eps_px};
        case ConservativeTest::Finding::tied:
            return {Admissibility::tied, false, eps_px};
        case ConservativeTest::Finding::undecided:
            break;
    }
    return decide_by_region(around, answer, coplanar);
}

DepthDecision may_lie_at(double inverse_depth, const Neighbourhood& around, PrimitiveId answer,
                         CoplanarCache& coplanar) {
    const std::optional<size_t> index = around.index_of(answer);
    if (!index) return {};
    Neighbourhood there = around;
    there.neighbours[*index].greatest_inverse_depth = inverse_depth;
    for (Neighbour& n : there.neighbours)
        n.may_be_missing |=
            n.triangle != there.neighbours[*index].triangle && share_an_edge(n, there.neighbours[*index]);
    const auto is_held = [&]<class Number>(AdmissibleSet<Number>& set) {
        try {
            return set.holds(*index, {DepthRule::bounded, set.edge_rule()}) || set.holds(*index, by_crack);
        } catch (const TooMuchWork&) {
            return true;
        }
    };
    AdmissibleSet<Interval> fast(there, coplanar);
    try {
        const bool may_lie_there = is_held(fast);
        return {may_lie_there, fast.work()};
    } catch (const UndecidedSign&) {
        AdmissibleSet<LazyRational> exact(there, coplanar);
        const bool may_lie_there = is_held(exact);
        return {may_lie_there, fast.work() + exact.work()};
    }
}

PixelClass class_of(Admissibility candidate, Admissibility reference) {
    if (is_admissible(candidate) && is_inadmissible(reference)) return PixelClass::reference_wrong;
    switch (is_admissible(candidate) && is_admissible(reference) ? std::max(candidate, reference)
                                                                 : candidate) {
        case Admissibility::visible:
            return PixelClass::edge;
        case Admissibility::clipped:
            return PixelClass::clip;
        case Admissibility::tied:
            return PixelClass::depth_tie;
        case Admissibility::through_a_crack:
            return PixelClass::abutting_edges;
        case Admissibility::undecidable:
            return PixelClass::undecidable;
        case Admissibility::hole:
            return PixelClass::hole;
        case Admissibility::outside:
            return PixelClass::outside;
        case Admissibility::hidden:
            return PixelClass::hidden;
    }
    throw std::logic_error{"class_of: an admissibility without a class"};
}

}  // namespace zproof
