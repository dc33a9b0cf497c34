// Sixteen lanes in two registers of floats, four of doubles: AVX2.
#include <immintrin.h>

#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::avx2 {
namespace {

/// All ones or all zeros, one per double.
struct WideMask {
    __m256d part[4];
};

/// The same, one per float.
struct Mask {
    __m256 low, high;
};

struct Doubles {
    __m256d part[4];
};

struct Floats {
    __m256 low, high;
};

WideMask operator&(const WideMask& a, const WideMask& b) {
    WideMask both;
    for (int i = 0; i < 4; ++i) both.part[i] = _mm256_and_pd(a.part[i], b.part[i]);
    return both;
}

Mask operator&(const Mask& a, const Mask& b) {
    return {_mm256_and_ps(a.low, b.low), _mm256_and_ps(a.high, b.high)};
}

unsigned bits_of(const WideMask& mask) {
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<unsigned>(_mm256_movemask_pd(mask.part[i])) << 4 * i;
    return bits;
}

unsigned bits_of(const Mask& mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(mask.low)) |
           static_cast<unsigned>(_mm256_movemask_ps(mask.high)) << 8;
}

/// Eight masks of 64 bits to eight of 32: the even halves, back in order.
__m256 halved(__m256d a, __m256d b) {
    const __m256 mixed = _mm256_shuffle_ps(_mm256_castpd_ps(a), _mm256_castpd_ps(b), 0b10'00'10'00);
    return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0b11'01'10'00));
}

Mask narrowed(const WideMask& mask) {
    return {halved(mask.part[0], mask.part[1]), halved(mask.part[2], mask.part[3])};
}

Doubles all(double value) {
    const __m256d part = _mm256_set1_pd(value);
    return {{part, part, part, part}};
}

Floats all(float value) { return {_mm256_set1_ps(value), _mm256_set1_ps(value)}; }

Doubles load(const double* values) {
    Doubles d;
    for (int i = 0; i < 4; ++i) d.part[i] = _mm256_load_pd(values + 4 * i);
    return d;
}

Floats load(const float* values) { return {_mm256_load_ps(values), _mm256_load_ps(values + 8)}; }

void store(double* to, const Doubles& values) {
    for (int i = 0; i < 4; ++i) _mm256_store_pd(to + 4 * i, values.part[i]);
}

Doubles operator+(const Doubles& a, const Doubles& b) {
    Doubles d;
    for (int i = 0; i < 4; ++i) d.part[i] = _mm256_add_pd(a.part[i], b.part[i]);
    return d;
}

Doubles operator*(const Doubles& a, double b) {
    Doubles d;
    for (int i = 0; i < 4; ++i) d.part[i] = _mm256_mul_pd(a.part[i], _mm256_set1_pd(b));
    return d;
}

WideMask at_least(const Doubles& a, double b) {
    WideMask mask;
    for (int i = 0; i < 4; ++i) mask.part[i] = _mm256_cmp_pd(a.part[i], _mm256_set1_pd(b), _CMP_GE_OQ);
    return mask;
}

Mask greater(const Floats& a, const Floats& b) {
    return {_mm256_cmp_ps(a.low, b.low, _CMP_GT_OQ), _mm256_cmp_ps(a.high, b.high, _CMP_GT_OQ)};
}

Floats rounded(const Doubles& a) {
    const auto pair = [&](int i) {
        return _mm256_set_m128(_mm256_cvtpd_ps(a.part[i + 1]), _mm256_cvtpd_ps(a.part[i]));
    };
    return {pair(0), pair(2)};
}

Floats chosen(const Mask& where, const Floats& a, const Floats& b) {
    return {_mm256_blendv_ps(b.low, a.low, where.low), _mm256_blendv_ps(b.high, a.high, where.high)};
}

void store(float* to, const Floats& values) {
    _mm256_store_ps(to, values.low);
    _mm256_store_ps(to + 8, values.high);
}

void put(std::uint32_t* to, const Mask& where, std::uint32_t value) {
    const __m256i values = _mm256_set1_epi32(static_cast<int>(value));
    const auto put_half = [&](void* half, __m256 mask) {
        __m256i* const at = static_cast<__m256i*>(half);
        _mm256_store_si256(at, _mm256_blendv_epi8(_mm256_load_si256(at), values, _mm256_castps_si256(mask)));
    };
    put_half(to, where.low);
    put_half(to + 8, where.high);
}

float least_of(const Floats& f) {
    const __m256 eight = _mm256_min_ps(f.low, f.high);
    const __m128 four = _mm_min_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
    const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_min_ss(two, _mm_shuffle_ps(two, two, 1)));
}

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. `to` is a
/// multiple of 16 bytes.
void stream_four(void* to, const void* four) {
    _mm_stream_si128(static_cast<__m128i*>(to), _mm_load_si128(static_cast<const __m128i*>(four)));
}
/// Before another thread may look.
void finish_streams() { _mm_sfence(); }

#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::avx2, "AVX2", project,          place,        resolve,
                    draw,      count,  draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::avx2
