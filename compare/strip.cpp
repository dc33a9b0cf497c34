#include "compare/strip.h"

#include <bit>

namespace zproof {

LawsAlong laws_along(const Strip& strip) {
    LawsAlong laws;
    std::size_t run = 0;
    spread_over_runs<Strip::width>(
        strip.turns, [&](std::size_t) { return strip.law_of_run[run++]; }, laws.candidate);
    laws.reference = laws.candidate;
    for (Strip::Pixels rest = strip.differ; rest != 0; rest &= rest - 1) {
        const auto i = std::size_t(std::countr_zero(rest));
        laws.reference[i] = strip.law_of_other[i];
    }
    return laws;
}

}  // namespace zproof
