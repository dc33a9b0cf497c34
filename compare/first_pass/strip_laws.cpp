#include "compare/first_pass/strip_laws.h"

#include <bit>

namespace zproof {

namespace {

Strip::Pixels chunks_of(Strip::Pixels pixels) {
    Strip::Pixels chunks = 0;
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk)
        if (Strip::in_chunk(pixels, first) != 0) chunks |= Strip::Pixels{all_columns} << first;
    return chunks;
}

}  // namespace

void StripLaws::look_up_around(Strip& strip, Strip::Pixels pixels) const {
    const Strip::Pixels around = chunks_of(pixels);
    std::uint32_t* law = strip.law_of_run.data();
    for (Strip::Pixels turns = strip.turns; turns != 0;) {
        const Strip::Pixels run = Strip::take_run(turns);
        const PrimitiveId triangle = strip.candidate.primitive[std::countr_zero(run)];
        *law++ = (run & around) != 0 ? law_of(triangle) : 0;
    }
    look_up_others(strip);
}

void StripLaws::look_up_what_differs(Strip& strip) const {
    for (Strip::Pixels rest = strip.differ; rest != 0;) {
        const PrimitiveId triangle = strip.reference.primitive[std::countr_zero(rest)];
        const Strip::Pixels here = rest & kernel_.where_shown(strip.reference.primitive, triangle);
        strip.others.of[std::size_t(strip.others.count++)] = {law_of(triangle), here};
        rest &= ~here;
    }
}

}  // namespace zproof
