/// Comparisons of sixteen numbers side by side, as masks. Left to itself, a compiler gathers the bits of such
/// a loop by fifteen instructions each of which waits for the one before.
#pragma once

#include "compare/tile_row.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace zproof {

#ifdef __SSE2__

/// holds(i): all ones where it is so for lanes i to i + 3, elsewhere zeros.
template <class Holds>
[[gnu::always_inline]] inline ColumnMask mask_where(const Holds& holds) {
    const __m128i low = _mm_packs_epi32(holds(0), holds(4)), high = _mm_packs_epi32(holds(8), holds(12));
    return ColumnMask(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
}

[[gnu::always_inline]] inline __m128i four_of(const PrimitiveId* ids) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(ids));
}
[[gnu::always_inline]] inline __m128i four_of(const std::uint32_t* numbers) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers));
}

/// Where a is b. Of ids and whole numbers.
template <class Id>
[[gnu::always_inline]] inline ColumnMask where_equal(const Id* a, const Id* b) {
    return mask_where([&](int i) __attribute__((always_inline)) {
        return _mm_cmpeq_epi32(four_of(a + i), four_of(b + i));
    });
}
template <class Id>
[[gnu::always_inline]] inline ColumnMask where_equal(const Id* a, Id b) {
    const __m128i four = _mm_set1_epi32(int(b));
    return mask_where([&](int i)
                          __attribute__((always_inline)) { return _mm_cmpeq_epi32(four_of(a + i), four); });
}
[[gnu::always_inline]] inline ColumnMask where_equal(const float* a, float b) {
    return mask_where([&](int i) __attribute__((always_inline)) {
        return _mm_castps_si128(_mm_cmpeq_ps(_mm_loadu_ps(a + i), _mm_set1_ps(b)));
    });
}

#else

template <class Holds>
ColumnMask mask_where(const Holds& holds) {
    ColumnMask mask = 0;
    for (std::size_t i = 0; i < tile_columns; ++i) mask |= ColumnMask(holds(i)) << i;
    return mask;
}

template <class Id>
ColumnMask where_equal(const Id* a, const Id* b) {
    return mask_where([&](std::size_t i) { return a[i] == b[i]; });
}
template <class Number>
ColumnMask where_equal(const Number* a, Number b) {
    return mask_where([&](std::size_t i) { return a[i] == b; });
}

#endif

}  // namespace zproof
