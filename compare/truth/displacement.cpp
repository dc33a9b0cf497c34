#include "compare/truth/displacement.h"

namespace zproof {

std::optional<double> displacement_over_eps(Estimate& estimate) {
    return least_step(estimate.around().eps_px, std::nullopt,
                      [&](double half_side_px) { return estimate.is_seen_within(half_side_px); });
}

}  // namespace zproof
