// Four lanes of doubles: AVX2.
#include "compare/strips/kernel.h"

#include <immintrin.h>

namespace zproof::strips::avx2 {
namespace {

constexpr int lanes = 4;

/// By the sign bit, one per double.
struct Mask {
    __m256d lanes;
};
struct Doubles {
    __m256d lanes;
};

Doubles all(double value) { return {_mm256_set1_pd(value)}; }
Doubles loaded(const double* values) { return {_mm256_loadu_pd(values)}; }
void store(const Doubles& values, double* to) { _mm256_storeu_pd(to, values.lanes); }
Doubles widened(const float* values) { return {_mm256_cvtps_pd(_mm_loadu_ps(values))}; }
Doubles widened(const std::int32_t* values) {
    return {_mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(values)))};
}
Doubles operator+(const Doubles& a, const Doubles& b) { return {_mm256_add_pd(a.lanes, b.lanes)}; }
Doubles operator-(const Doubles& a, const Doubles& b) { return {_mm256_sub_pd(a.lanes, b.lanes)}; }
Doubles operator*(const Doubles& a, const Doubles& b) { return {_mm256_mul_pd(a.lanes, b.lanes)}; }
Doubles magnitude(const Doubles& a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lanes)}; }
Doubles operator/(const Doubles& a, const Doubles& b) { return {_mm256_div_pd(a.lanes, b.lanes)}; }
/// b only where it is smaller.
Doubles lesser(const Doubles& a, const Doubles& b) { return {_mm256_min_pd(b.lanes, a.lanes)}; }
/// b only where it is larger.
Doubles greater(const Doubles& a, const Doubles& b) { return {_mm256_max_pd(b.lanes, a.lanes)}; }
/// To each lane the value at its place: places are bytes, below four.
Doubles at_places(const double* values, std::uint64_t places) {
    const __m256i whole = _mm256_cvtepu8_epi64(_mm_cvtsi64_si128(static_cast<long long>(places))),
                  halves = _mm256_add_epi64(whole, whole);  // of which each place has two
    const __m256i both = _mm256_or_si256(halves, _mm256_slli_epi64(halves, 32));
    const __m256i lanes_places = _mm256_add_epi64(both, _mm256_set1_epi64x(0x1'0000'0000));
    const __m256 from = _mm256_castpd_ps(_mm256_loadu_pd(values));
    return {_mm256_castps_pd(_mm256_permutevar8x32_ps(from, lanes_places))};
}

/// Places in tables.
struct Indices {
    __m128i lanes;
};
Indices loaded(const std::uint32_t* indices) {
    return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(indices))};
}
Doubles gathered(const float* table, const Indices& at) {
    return {_mm256_cvtps_pd(_mm_i32gather_ps(table, at.lanes, 4))};
}

/// False of a NaN.
Mask less(const Doubles& a, const Doubles& b) { return {_mm256_cmp_pd(a.lanes, b.lanes, _CMP_LT_OQ)}; }
Mask not_greater(const Doubles& a, const Doubles& b) { return {_mm256_cmp_pd(a.lanes, b.lanes, _CMP_LE_OQ)}; }
Mask operator&(const Mask& a, const Mask& b) { return {_mm256_and_pd(a.lanes, b.lanes)}; }
/// Where it is said, a; elsewhere b.
Doubles chosen(const Mask& mask, const Doubles& a, const Doubles& b) {
    return {_mm256_blendv_pd(b.lanes, a.lanes, mask.lanes)};
}
unsigned bits_of(const Mask& mask) { return static_cast<unsigned>(_mm256_movemask_pd(mask.lanes)); }

/// Of eight.
__m256i ids_of_half(const PrimitiveId* ids) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ids));
}
unsigned where_equal(__m256i a, __m256i b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b))));
}
unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    return where_equal(ids_of_half(a), ids_of_half(b)) | where_equal(ids_of_half(a + 8), ids_of_half(b + 8))
                                                             << 8;
}
unsigned where_equal(const PrimitiveId* a, PrimitiveId b) {
    const __m256i eight = _mm256_set1_epi32(int(b));
    return where_equal(ids_of_half(a), eight) | where_equal(ids_of_half(a + 8), eight) << 8;
}

/// Of eight.
unsigned where_background_of_half(const float* depth) {
    const __m256 bare = _mm256_cmp_ps(_mm256_loadu_ps(depth), _mm256_set1_ps(background_depth), _CMP_EQ_OQ);
    return static_cast<unsigned>(_mm256_movemask_ps(bare));
}
/// Of sixteen.
unsigned where_background(const float* depth) {
    return where_background_of_half(depth) | where_background_of_half(depth + 8) << 8;
}

/// Of eight, or sixteen: where a value and what is added to it lie above a limit, and where below minus that.
Beyond beyond_in_half(const float* values, float added, float limit) {
    const __m256 sum = _mm256_add_ps(_mm256_loadu_ps(values), _mm256_set1_ps(added));
    const __m256 above = _mm256_cmp_ps(sum, _mm256_set1_ps(limit), _CMP_GT_OQ),
                 below = _mm256_cmp_ps(sum, _mm256_set1_ps(-limit), _CMP_LT_OQ);
    return {static_cast<unsigned>(_mm256_movemask_ps(above)),
            static_cast<unsigned>(_mm256_movemask_ps(below))};
}
Beyond beyond(const float* values, float added, float limit) {
    const Beyond first = beyond_in_half(values, added, limit),
                 second = beyond_in_half(values + 8, added, limit);
    return {first.above | second.above << 8, first.below | second.below << 8};
}

#include "compare/strips/kernel.inl"

}  // namespace

constinit const Kernel kernel = kernel_named("AVX2");

}  // namespace zproof::strips::avx2
