// Sixteen lanes in one register of floats, two of doubles: AVX-512 F, VL, BW, DQ.
#include <immintrin.h>

#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::avx512 {
namespace {

struct Mask {
    __mmask16 lanes = 0;
};

unsigned bits_of(Mask mask) { return _cvtmask16_u32(mask.lanes); }

struct Doubles {
    __m512d low, high;
};

struct Floats {
    __m512 lanes;
};

struct Ints {
    __m512i lanes;
};

Mask negative(const Ints& a) { return {_mm512_movepi32_mask(a.lanes)}; }
unsigned negative_lanes(const Ints& a) { return bits_of(negative(a)); }
Mask without_negative(Mask mask, const Ints& a) { return {_kandn_mask16(negative(a).lanes, mask.lanes)}; }
Ints splat(std::int32_t value) { return {_mm512_set1_epi32(value)}; }
Ints load(const std::int32_t* values) { return {_mm512_load_si512(values)}; }
void store(std::int32_t* to, const Ints& values) { _mm512_store_si512(to, values.lanes); }
Ints operator+(const Ints& a, const Ints& b) { return {_mm512_add_epi32(a.lanes, b.lanes)}; }
Ints operator*(const Ints& a, std::int32_t b) { return {_mm512_mullo_epi32(a.lanes, _mm512_set1_epi32(b))}; }
Ints operator|(const Ints& a, const Ints& b) { return {_mm512_or_si512(a.lanes, b.lanes)}; }

/// `set` with `bit` besides where a value is not negative.
Ints with_bit_where_not_negative(const Ints& set, std::int32_t bit, const Ints& values) {
    const __m512i bits = _mm512_andnot_si512(_mm512_srai_epi32(values.lanes, 31), _mm512_set1_epi32(bit));
    return {_mm512_or_si512(set.lanes, bits)};
}

Doubles splat(double value) { return {_mm512_set1_pd(value), _mm512_set1_pd(value)}; }
Floats splat(float value) { return {_mm512_set1_ps(value)}; }
Doubles load(const double* values) { return {_mm512_load_pd(values), _mm512_load_pd(values + 8)}; }
Floats load(const float* values) { return {_mm512_load_ps(values)}; }

/// Four rows of four, `stride` apart.
Floats load_square(const float* values, std::ptrdiff_t stride) {
    const __m512 first = _mm512_castps128_ps512(_mm_loadu_ps(values));
    const __m512 two = _mm512_insertf32x4(first, _mm_loadu_ps(values + stride), 1);
    const __m512 three = _mm512_insertf32x4(two, _mm_loadu_ps(values + 2 * stride), 2);
    return {_mm512_insertf32x4(three, _mm_loadu_ps(values + 3 * stride), 3)};
}

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

Doubles operator*(const Doubles& a, const Doubles& b) {
    return {_mm512_mul_pd(a.low, b.low), _mm512_mul_pd(a.high, b.high)};
}

Doubles doubles_of(const Ints& a) {
    return {_mm512_cvtepi32_pd(_mm512_castsi512_si256(a.lanes)),
            _mm512_cvtepi32_pd(_mm512_extracti64x4_epi64(a.lanes, 1))};
}

/// Clamps whole numbers to [-most, most].
Ints clamped(const Doubles& a, double most) {
    const auto half = [&](const __m512d& lanes) {
        const __m512d at_most = _mm512_min_pd(lanes, _mm512_set1_pd(most));
        return _mm512_cvttpd_epi32(_mm512_max_pd(at_most, _mm512_set1_pd(-most)));
    };
    return {_mm512_inserti32x8(_mm512_castsi256_si512(half(a.low)), half(a.high), 1)};
}

Mask greater(const Floats& a, const Floats& b) { return {_mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_GT_OQ)}; }
Mask not_less(const Floats& a, const Floats& b) { return {_mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_GE_OQ)}; }
Mask equal(const Floats& a, const Floats& b) { return {_mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_EQ_OQ)}; }
Mask operator|(Mask a, Mask b) { return {_kor_mask16(a.lanes, b.lanes)}; }

/// The lanes of `where` that hold more than `least`.
Mask above(Mask where, const std::uint32_t* values, std::uint32_t least) {
    return {_mm512_mask_cmpgt_epu32_mask(where.lanes, _mm512_load_si512(values),
                                         _mm512_set1_epi32(static_cast<int>(least)))};
}

Floats rounded(const Doubles& a) {
    const __m512 low = _mm512_castps256_ps512(_mm512_cvtpd_ps(a.low));
    return {_mm512_insertf32x8(low, _mm512_cvtpd_ps(a.high), 1)};
}

Floats select(Mask where, const Floats& a, const Floats& b) {
    return {_mm512_mask_blend_ps(where.lanes, b.lanes, a.lanes)};
}

void store(float* to, const Floats& values) { _mm512_store_ps(to, values.lanes); }

void put(std::uint32_t* to, Mask where, std::uint32_t value) {
    _mm512_mask_store_epi32(to, where.lanes, _mm512_set1_epi32(static_cast<int>(value)));
}

float least_of(const Floats& f) { return _mm512_reduce_min_ps(f.lanes); }

/// Stores the least of each of four times sixteen values.
void store_least_of_four(float* to, const float* values) {
    const auto halves = [](const __m512& a, const __m512& b) {
        return _mm512_min_ps(_mm512_shuffle_f32x4(a, b, 0x44), _mm512_shuffle_f32x4(a, b, 0xEE));
    };
    const __m512 ab = halves(_mm512_load_ps(values), _mm512_load_ps(values + 16));
    const __m512 cd = halves(_mm512_load_ps(values + 32), _mm512_load_ps(values + 48));
    const __m512 quarters =
        _mm512_min_ps(_mm512_shuffle_f32x4(ab, cd, 0x88), _mm512_shuffle_f32x4(ab, cd, 0xDD));
    const __m512 pairs = _mm512_min_ps(quarters, _mm512_permute_ps(quarters, 0b01'00'11'10));
    const __m512 least = _mm512_min_ps(pairs, _mm512_permute_ps(pairs, 0b10'11'00'01));
    const __m512i first_of_four = _mm512_setr_epi32(0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12);
    _mm_storeu_ps(to, _mm512_castps512_ps128(_mm512_permutexvar_ps(first_of_four, least)));
}

/// Writes index + 16 b for every bit b of the sixteen, and perhaps something after them. Returns how many
/// there are.
int put_bits(std::uint8_t* to, unsigned bits, int index) {
    const __m512i of_bits =
        _mm512_setr_epi32(0, 16, 32, 48, 64, 80, 96, 112, 128, 144, 160, 176, 192, 208, 224, 240);
    const __m512i indices = _mm512_add_epi32(of_bits, _mm512_set1_epi32(index));
    const __m512i of_set = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), indices);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm512_cvtepi32_epi8(of_set));
    return __builtin_popcount(bits);
}

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. `to` is a
/// multiple of 16 bytes.
void stream_four(void* to, const void* four) {
    _mm_stream_si128(static_cast<__m128i*>(to), _mm_load_si128(static_cast<const __m128i*>(four)));
}
/// Makes streamed stores visible before another thread may look.
void publish() noexcept { _mm_sfence(); }

/// Sixteen vertices of 16 bytes each.
void put_side_by_side(const SnappedVertex* const (&vertex)[16], std::int32_t* x, std::int32_t* y,
                      double* inverse_depth) {
    const auto four_from = [&](int i) {
        const auto part = [&](int k) {
            return _mm_loadu_si128(reinterpret_cast<const __m128i*>(vertex[i + k]));
        };
        const __m512i two = _mm512_inserti32x4(_mm512_castsi128_si512(part(0)), part(1), 1);
        return _mm512_inserti32x4(_mm512_inserti32x4(two, part(2), 2), part(3), 3);
    };
    const __m512i x_then_y = _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
    const __m512i odd = _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15);
    const __m512i a = four_from(0), b = four_from(4), c = four_from(8), d = four_from(12);
    const __m512i first = _mm512_permutex2var_epi32(a, x_then_y, b),
                  last = _mm512_permutex2var_epi32(c, x_then_y, d);
    _mm512_store_si512(x, _mm512_shuffle_i64x2(first, last, 0x44));
    _mm512_store_si512(y, _mm512_shuffle_i64x2(first, last, 0xEE));
    _mm512_store_si512(inverse_depth, _mm512_permutex2var_epi64(a, odd, b));
    _mm512_store_si512(inverse_depth + 8, _mm512_permutex2var_epi64(c, odd, d));
}

#include "rasterizer/corners_avx.inl"
#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::avx512, "AVX-512", project,          place,        clear,      resolve, publish,
                    draw,        count,     draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::avx512
