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
/// 0, 1, 2 and so on.
Doubles counted() { return {_mm512_setr_pd(0, 1, 2, 3, 4, 5, 6, 7)}; }
Doubles loaded(const double* values) { return {_mm512_loadu_pd(values)}; }
void store(const Doubles& values, double* to) { _mm512_storeu_pd(to, values.lanes); }
Doubles widened(const float* values) { return {_mm512_cvtps_pd(_mm256_loadu_ps(values))}; }
Doubles operator+(const Doubles& a, const Doubles& b) { return {_mm512_add_pd(a.lanes, b.lanes)}; }
Doubles operator-(const Doubles& a, const Doubles& b) { return {_mm512_sub_pd(a.lanes, b.lanes)}; }
Doubles operator*(const Doubles& a, const Doubles& b) { return {_mm512_mul_pd(a.lanes, b.lanes)}; }
Doubles magnitude(const Doubles& a) { return {_mm512_abs_pd(a.lanes)}; }

/// False of a NaN.
Mask not_greater(const Doubles& a, const Doubles& b) {
    return {_mm512_cmp_pd_mask(a.lanes, b.lanes, _CMP_LE_OQ)};
}
Mask operator&(Mask a, Mask b) { return {__mmask8(a.lanes & b.lanes)}; }
unsigned bits_of(Mask mask) { return _cvtmask8_u32(mask.lanes); }

unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    return _cvtmask16_u32(_mm512_cmpeq_epi32_mask(_mm512_loadu_si512(a), _mm512_loadu_si512(b)));
}

/// Of sixteen.
unsigned where_background(const float* depth) {
    return _cvtmask16_u32(
        _mm512_cmp_ps_mask(_mm512_loadu_ps(depth), _mm512_set1_ps(background_depth), _CMP_EQ_OQ));
}

#include "compare/strips/certain.inl"
#include "compare/strips/ids.inl"

}  // namespace

const Kernel kernel{"AVX-512", compare, certain};

}  // namespace zproof::strips::avx512
