#include "compare/displacement.h"

#include "compare/admissible.h"

namespace zproof {

std::optional<double> displacement_over_eps(const Neighbourhood& around, PrimitiveId answer) {
    AdmissibleSet<double> set(around);
    const std::optional<size_t> index = around.index_of(answer);
    return least_step(around.eps_px, [&](double half_side_px) {
        set.set_half_side(half_side_px);
        if (answer == PrimitiveId::none) return set.holds_background(EdgeRule::watertight);
        return index && set.is_seen(*index);
    });
}

}  // namespace zproof
