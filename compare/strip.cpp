#include "compare/strip.h"

#include "compare/masks.h"

namespace zproof {

namespace {

using Ids = const PrimitiveId*;

/// Where two rows of ids differ.
Strip::Pixels differing(Ids a, Ids b) {
    Strip::Pixels same = 0;
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk)
        same |= Strip::Pixels{where_equal(a + first, b + first)} << first;
    return ~same;
}

/// Where a row of ids is not what it was a pixel before; not asked of the first.
Strip::Pixels turning(Ids a) {
    Strip::Pixels same = 1;
    for (const std::size_t first : {0, 16, 32, 47})  // none reads behind the last pixel
        same |= Strip::Pixels{where_equal(a + first + 1, a + first)} << (first + 1);
    return ~same;
}

}  // namespace

void compare_ids(Strip& strip) {
    const Ids shown = strip.candidate.primitive;
    strip.turns = turning(shown) | 1;
    strip.differ = differing(shown, strip.reference.primitive);
}

}  // namespace zproof
