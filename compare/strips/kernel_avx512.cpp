// Eight lanes of doubles: AVX-512 F, VL, BW, DQ.
#include "compare/strips/kernel.h"

#include <immintrin.h>

namespace zproof::strips::avx512 {
namespace {

constexpr int lanes = 8;

struct Mask {
    __mmask8 lanes;
};
struct Doubles {
    __m512d lanes;
};

Doubles all(double value) { return {_mm512_set1_pd(value)}; }
Doubles loaded(const double* values) { return {_mm512_loadu_pd(values)}; }
void store(const Doubles& values, double* to) { _mm512_storeu_pd(to, values.lanes); }
Doubles widened(const float* values) { return {_mm512_cvtps_pd(_mm256_loadu_ps(values))}; }
Doubles widened(const std::int32_t* values) {
    return {_mm512_cvtepi32_pd(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(values)))};
}
Doubles operator+(const Doubles& a, const Doubles& b) { return {_mm512_add_pd(a.lanes, b.lanes)}; }
Doubles operator-(const Doubles& a, const Doubles& b) { return {_mm512_sub_pd(a.lanes, b.lanes)}; }
Doubles operator*(const Doubles& a, const Doubles& b) { return {_mm512_mul_pd(a.lanes, b.lanes)}; }
Doubles magnitude(const Doubles& a) { return {_mm512_abs_pd(a.lanes)}; }
Doubles operator/(const Doubles& a, const Doubles& b) { return {_mm512_div_pd(a.lanes, b.lanes)}; }
/// b only where it is smaller.
Doubles lesser(const Doubles& a, const Doubles& b) { return {_mm512_min_pd(b.lanes, a.lanes)}; }
/// b only where it is larger.
Doubles greater(const Doubles& a, const Doubles& b) { return {_mm512_max_pd(b.lanes, a.lanes)}; }
/// To each lane the value at its place: places are bytes, below eight.
Doubles at_places(const double* values, std::uint64_t places) {
    const __m512i lanes_places = _mm512_cvtepu8_epi64(_mm_cvtsi64_si128(static_cast<long long>(places)));
    return {_mm512_permutexvar_pd(lanes_places, _mm512_loadu_pd(values))};
}

/// Places in tables.
struct Indices {
    __m256i lanes;
};
Indices loaded(const std::uint32_t* indices) {
    return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(indices))};
}
Doubles gathered(const float* table, const Indices& at) {
    return {_mm512_cvtps_pd(_mm256_i32gather_ps(table, at.lanes, 4))};
}

/// False of a NaN.
Mask not_greater(const Doubles& a, const Doubles& b) {
    return {_mm512_cmp_pd_mask(a.lanes, b.lanes, _CMP_LE_OQ)};
}
Mask less(const Doubles& a, const Doubles& b) { return {_mm512_cmp_pd_mask(a.lanes, b.lanes, _CMP_LT_OQ)}; }
Mask operator&(Mask a, Mask b) { return {__mmask8(a.lanes & b.lanes)}; }
/// Where it is said, a; elsewhere b.
Doubles chosen(Mask mask, const Doubles& a, const Doubles& b) {
    return {_mm512_mask_mov_pd(b.lanes, mask.lanes, a.lanes)};
}
unsigned bits_of(Mask mask) { return _cvtmask8_u32(mask.lanes); }

unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    return _cvtmask16_u32(_mm512_cmpeq_epi32_mask(_mm512_loadu_si512(a), _mm512_loadu_si512(b)));
}

unsigned where_equal(const PrimitiveId* a, PrimitiveId b) {
    return _cvtmask16_u32(_mm512_cmpeq_epi32_mask(_mm512_loadu_si512(a), _mm512_set1_epi32(int(b))));
}

/// Of sixteen.
unsigned where_background(const float* depth) {
    return _cvtmask16_u32(
        _mm512_cmp_ps_mask(_mm512_loadu_ps(depth), _mm512_set1_ps(background_depth), _CMP_EQ_OQ));
}

/// Of sixteen: where a value and what is added to it lie above a limit, and where below minus that.
Beyond beyond(const float* values, float added, float limit) {
    const __m512 sum = _mm512_add_ps(_mm512_loadu_ps(values), _mm512_set1_ps(added));
    return {_cvtmask16_u32(_mm512_cmp_ps_mask(sum, _mm512_set1_ps(limit), _CMP_GT_OQ)),
            _cvtmask16_u32(_mm512_cmp_ps_mask(sum, _mm512_set1_ps(-limit), _CMP_LT_OQ))};
}

#include "compare/strips/kernel.inl"

}  // namespace

constinit const Kernel kernel = kernel_named("AVX-512");

}  // namespace zproof::strips::avx512
