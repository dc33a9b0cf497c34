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

/// So many ids from there on. Compilers make vectors of it.
[[gnu::always_inline]] inline bool are_same(Ids a, Ids b, std::size_t count) {
    std::uint32_t different = 0;
    for (std::size_t i = 0; i < count; ++i) different |= std::uint32_t(a[i]) ^ std::uint32_t(b[i]);
    return different == 0;
}

}  // namespace

/// Most rows are the same in both frames, and many show one triangle: both are told sooner than where not.
[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] void compare_ids(Strip& strip) {
    const Ids ours = strip.candidate.primitive, theirs = strip.reference.primitive;
    strip.turns = are_same(ours + 1, ours, Strip::width - 1) ? 1 : turning(ours) | 1;
    strip.differ = are_same(ours, theirs, Strip::width) ? 0 : differing(ours, theirs);
}

}  // namespace zproof
