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

/// `clipped` where a plane may have a part in it, and that is to be told.
template <class Number>
Admissibility visible_in(AdmissibleSet<Number>& set, size_t count, AskedReason reason) {
    for (size_t i = 0; reason == AskedReason::the_first && i < count; ++i)
        if (set.is_clipped(i)) return Admissibility::clipped;
    return Admissibility::visible;
}

template <class Number>
Admissibility of_background(AdmissibleSet<Number>& set, size_t count, AskedReason reason) {
    if (set.holds_background(set.edge_rule())) return visible_in(set, count, reason);
    return set.holds_background(EdgeRule::separate) ? Admissibility::through_a_crack : Admissibility::hole;
}

template <class Number>
Admissibility of_triangle(AdmissibleSet<Number>& set, size_t index, size_t count, AskedReason reason) {
    if (!set.is_shown(index)) return Admissibility::outside;
    if (set.is_seen(index)) return visible_in(set, count, reason);
    if (set.holds(index, {DepthRule::bounded, set.edge_rule()})) return Admissibility::tied;
    return set.holds(index, by_crack) ? Admissibility::through_a_crack : Admissibility::hidden;
}

template <class Number>
Admissibility admissibility_in(AdmissibleSet<Number>& set, const Neighbourhood& around, PrimitiveId answer,
                               AskedReason reason) {
    const size_t count = around.neighbours.size();
    if (answer == PrimitiveId::none) return of_background(set, count, reason);
    const std::optional<size_t> index = around.index_of(answer);
    return index ? of_triangle(set, *index, count, reason) : Admissibility::outside;
}

/// What was asked of a set; nothing where it would take too much work.
template <class Answer>
struct Asked {
    std::optional<Answer> answer;
    bool exact;  ///< did intervals leave it to rationals?
    std::size_t work;
};

/// Asks the admissible set by intervals, then by rationals.
template <class Answer, class Ask>
Asked<Answer> ask_set(const Neighbourhood& around, const Ask& ask) {
    const auto ask_within_limits = [&](auto& set) -> std::optional<Answer> {
        try {
            return ask(set);
        } catch (const TooMuchWork&) {
            return std::nullopt;
        }
    };
    AdmissibleSet<Interval> fast(around);
    try {
        const std::optional<Answer> answer = ask_within_limits(fast);
        return {answer, false, fast.work()};
    } catch (const UndecidedSign&) {
        AdmissibleSet<LazyRational> exact(around);
        const std::optional<Answer> answer = ask_within_limits(exact);
        return {answer, true, fast.work() + exact.work()};
    }
}

/// Do two corners of one stand where two of the other do?
bool share_an_edge(const Neighbour& a, const Neighbour& b) {
    return std::ranges::count_if(a.p_world, [&](const glm::vec3& p) {
               return std::ranges::find(b.p_world, p) != b.p_world.end();
           }) >= 2;
}

}  // namespace

Decision decide(const Neighbourhood& around, PrimitiveId answer, AskedReason reason) {
    const double eps_px = around.eps_px;
    const ConservativeTest::Finding certain = ConservativeTest(around, answer).finding();
    if (certain == ConservativeTest::Finding::visible) return {Admissibility::visible, false, eps_px};
    if (certain == ConservativeTest::Finding::tied) return {Admissibility::tied, false, eps_px};
    const auto [found, exact, work] = ask_set<Admissibility>(
        around, [&](auto& set) { return admissibility_in(set, around, answer, reason); });
    return {found.value_or(Admissibility::undecidable), exact, eps_px, work};
}

DepthDecision may_lie_at(double inverse_depth, const Neighbourhood& around, PrimitiveId answer) {
    const std::optional<size_t> index = around.index_of(answer);
    if (!index) return {};
    Neighbourhood there = around;
    there.neighbours[*index].greatest_inverse_depth = inverse_depth;
    for (Neighbour& n : there.neighbours)
        n.may_be_missing |=
            n.triangle != there.neighbours[*index].triangle && share_an_edge(n, there.neighbours[*index]);
    const auto [may_lie_there, exact, work] = ask_set<bool>(there, [&](auto& set) {
        return set.holds(*index, {DepthRule::bounded, set.edge_rule()}) || set.holds(*index, by_crack);
    });
    return {may_lie_there.value_or(true), work};
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
