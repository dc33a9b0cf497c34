#include "compare/displacement.h"

#include "compare/admissible.h"

namespace zproof {

namespace {

constexpr int steps = 1024;

/// The same question as for Standing::visible.
bool is_seen(AdmissibleSet<double>& set, const Neighbourhood& around, PrimitiveId answer) {
    if (answer == PrimitiveId::none) return set.holds_background(EdgeRule::watertight);
    const std::optional<size_t> index = around.index_of(answer);
    return index && set.is_seen(*index);
}

}  // namespace

/// What is seen in a square is seen in every larger one: bisection.
std::optional<double> displacement_over_eps(const Neighbourhood& around, PrimitiveId answer) {
    AdmissibleSet<double> set(around);
    const auto is_seen_within = [&](int step) {
        set.set_half_side(around.eps_px * step / steps);
        return is_seen(set, around, answer);
    };
    if (is_seen_within(1)) return std::nullopt;
    int too_small = 1, enough = steps;
    while (enough - too_small > 1) {
        const int middle = (too_small + enough) / 2;
        (is_seen_within(middle) ? enough : too_small) = middle;
    }
    return double(too_small) / steps;
}

}  // namespace zproof
