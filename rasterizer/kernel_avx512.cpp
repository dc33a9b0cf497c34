// Sixteen lanes in one register of floats, two of doubles: AVX-512 F, VL, BW, DQ.
#include <immintrin.h>

#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::avx512 {
namespace {

struct Mask {
    __mmask16 lanes = 0;
};

Mask operator&(Mask a, Mask b) { return {_kand_mask16(a.lanes, b.lanes)}; }
unsigned bits_of(Mask mask) { return _cvtmask16_u32(mask.lanes); }
Mask narrowed(Mask mask) { return mask; }

struct Doubles {
    __m512d low, high;
};

struct Floats {
    __m512 lanes;
};

Doubles all(double value) { return {_mm512_set1_pd(value), _mm512_set1_pd(value)}; }
Floats all(float value) { return {_mm512_set1_ps(value)}; }
Doubles load(const double* values) { return {_mm512_load_pd(values), _mm512_load_pd(values + 8)}; }
Floats load(const float* values) { return {_mm512_load_ps(values)}; }

void store(double* to, const Doubles& values) {
    _mm512_store_pd(to, values.low);
    _mm512_store_pd(to + 8, values.high);
}

Doubles operator+(const Doubles& a, const Doubles& b) {
    return {_mm512_add_pd(a.low, b.low), _mm512_add_pd(a.high, b.high)};
}

Doubles operator*(const Doubles& a, double b) {
    const __m512d factor = _mm512_set1_pd(b);
    return {_mm512_mul_pd(a.low, factor), _mm512_mul_pd(a.high, factor)};
}

Mask at_least(const Doubles& a, double b) {
    const __m512d bound = _mm512_set1_pd(b);
    return {_mm512_kunpackb(_mm512_cmp_pd_mask(a.high, bound, _CMP_GE_OQ),
                            _mm512_cmp_pd_mask(a.low, bound, _CMP_GE_OQ))};
}

Mask greater(const Floats& a, const Floats& b) { return {_mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_GT_OQ)}; }

Floats rounded(const Doubles& a) {
    const __m512 low = _mm512_castps256_ps512(_mm512_cvtpd_ps(a.low));
    return {_mm512_insertf32x8(low, _mm512_cvtpd_ps(a.high), 1)};
}

Floats chosen(Mask where, const Floats& a, const Floats& b) {
    return {_mm512_mask_blend_ps(where.lanes, b.lanes, a.lanes)};
}

void store(float* to, const Floats& values) { _mm512_store_ps(to, values.lanes); }

void put(std::uint32_t* to, Mask where, std::uint32_t value) {
    _mm512_mask_store_epi32(to, where.lanes, _mm512_set1_epi32(static_cast<int>(value)));
}

float least_of(const Floats& f) { return _mm512_reduce_min_ps(f.lanes); }

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. `to` is a
/// multiple of 16 bytes.
void stream_four(void* to, const void* four) {
    _mm_stream_si128(static_cast<__m128i*>(to), _mm_load_si128(static_cast<const __m128i*>(four)));
}
/// Before another thread may look.
void finish_streams() { _mm_sfence(); }

#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::avx512, "AVX-512", project,          place,        resolve,
                    draw,        count,     draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::avx512
