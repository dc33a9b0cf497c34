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

/// Puts a value where the mask says so; the others of those sixteen are written as they are.
template <class Byte>
[[gnu::always_inline]] inline void put_where(ColumnMask mask, Byte value, Byte* row) {
    static_assert(sizeof(Byte) == 1);
    const __m128i twice = _mm_unpacklo_epi8(_mm_cvtsi32_si128(int(mask)), _mm_cvtsi32_si128(int(mask)));
    const __m128i four_times = _mm_unpacklo_epi16(twice, twice);
    const __m128i half_a_mask_each = _mm_unpacklo_epi32(four_times, four_times);
    const __m128i own_bit = _mm_set1_epi64x(std::int64_t(0x8040'2010'0804'0201u));
    const __m128i chosen = _mm_cmpeq_epi8(_mm_and_si128(half_a_mask_each, own_bit), own_bit);
    auto* const place = reinterpret_cast<__m128i*>(row);
    const __m128i values = _mm_set1_epi8(static_cast<char>(value)), before = _mm_loadu_si128(place);
    _mm_storeu_si128(place, _mm_or_si128(_mm_and_si128(chosen, values), _mm_andnot_si128(chosen, before)));
}

#else

template <class Byte>
void put_where(ColumnMask mask, Byte value, Byte* row) {
    for (std::size_t i = 0; i < tile_columns; ++i)
        if ((mask >> i & 1) != 0) row[i] = value;
}

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
