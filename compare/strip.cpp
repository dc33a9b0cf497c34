#include "compare/strip.h"

#include <algorithm>

namespace zproof {

namespace {

using Ids = const PrimitiveId*;

/// Where two rows of ids differ. Compilers make vectors of it.
[[gnu::always_inline]] inline Strip::Pixels differing(Ids a, Ids b) {
    constexpr std::size_t half = Strip::width / 2;
    const auto in_half = [&](std::size_t first) {
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < half; ++i) mask |= std::uint32_t(a[first + i] != b[first + i]) << i;
        return mask;
    };
    return in_half(0) | Strip::Pixels{in_half(half)} << half;
}

}  // namespace

[[gnu::target_clones("default", "avx2", "avx512f")]] void compare_ids(Strip& strip) {
    const Ids shown = strip.candidate.primitive;
    std::array<PrimitiveId, Strip::width> before;
    before[0] = shown[0];
    std::copy_n(shown, Strip::width - 1, before.begin() + 1);
    strip.turns = differing(shown, before.data()) | 1;
    strip.differ = differing(shown, strip.reference.primitive);
}

}  // namespace zproof
