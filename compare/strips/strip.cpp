#include "compare/strips/strip.h"

#include <bit>
#include <span>

namespace zproof {

LawsAlong laws_along(const Strip& strip) {
    LawsAlong laws;
    std::size_t run = 0;
    spread_over_runs<Strip::width>(
        strip.turns, [&](std::size_t) { return strip.law_of_run[run++]; }, laws.candidate);
    laws.reference = laws.candidate;
    for (const auto& [law, pixels] : std::span(strip.others.of.data(), std::size_t(strip.others.count)))
        for (Strip::Pixels rest = pixels; rest != 0; rest &= rest - 1)
            laws.reference[std::size_t(std::countr_zero(rest))] = law;
    return laws;
}

Strip::ShownOnes candidates_where_they_differ(const Strip& strip) {
    Strip::ShownOnes shown;
    const std::uint32_t* law = strip.law_of_run.data();
    for (Strip::Pixels turns = strip.turns; turns != 0; ++law) {
        const Strip::Pixels run = Strip::take_run(turns);
        if ((run & strip.differ) != 0) shown.of[std::size_t(shown.count++)] = {*law, run & strip.differ};
    }
    return shown;
}

}  // namespace zproof
