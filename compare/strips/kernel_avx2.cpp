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
/// 0, 1, 2 and so on.
Doubles counted() { return {_mm256_setr_pd(0, 1, 2, 3)}; }
Doubles loaded(const double* values) { return {_mm256_loadu_pd(values)}; }
void store(const Doubles& values, double* to) { _mm256_storeu_pd(to, values.lanes); }
Doubles widened(const float* values) { return {_mm256_cvtps_pd(_mm_loadu_ps(values))}; }
Doubles operator+(const Doubles& a, const Doubles& b) { return {_mm256_add_pd(a.lanes, b.lanes)}; }
Doubles operator-(const Doubles& a, const Doubles& b) { return {_mm256_sub_pd(a.lanes, b.lanes)}; }
Doubles operator*(const Doubles& a, const Doubles& b) { return {_mm256_mul_pd(a.lanes, b.lanes)}; }
Doubles magnitude(const Doubles& a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lanes)}; }

/// False of a NaN.
Mask not_greater(const Doubles& a, const Doubles& b) { return {_mm256_cmp_pd(a.lanes, b.lanes, _CMP_LE_OQ)}; }
Mask operator&(const Mask& a, const Mask& b) { return {_mm256_and_pd(a.lanes, b.lanes)}; }
unsigned bits_of(const Mask& mask) { return static_cast<unsigned>(_mm256_movemask_pd(mask.lanes)); }

/// Of eight.
unsigned where_equal_of_half(const PrimitiveId* a, const PrimitiveId* b) {
    const __m256i ours = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(a)),
                  theirs = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b));
    const __m256 same = _mm256_castsi256_ps(_mm256_cmpeq_epi32(ours, theirs));
    return static_cast<unsigned>(_mm256_movemask_ps(same));
}
unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    return where_equal_of_half(a, b) | where_equal_of_half(a + 8, b + 8) << 8;
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

#include "compare/strips/certain.inl"
#include "compare/strips/ids.inl"

}  // namespace

const Kernel kernel{"AVX2", compare, certain};

}  // namespace zproof::strips::avx2
