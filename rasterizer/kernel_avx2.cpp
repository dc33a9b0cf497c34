// Sixteen lanes in two registers of floats, four of doubles: AVX2.
#include <immintrin.h>

#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::avx2 {
namespace {

/// A mask of floats; the sign bit of each one counts.
struct Mask {
    __m256 low, high;
};

struct Doubles {
    __m256d part[4];
};

struct Floats {
    __m256 low, high;
};

struct Ints {
    __m256i low, high;
};

unsigned bits_of(const Mask& mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(mask.low)) |
           static_cast<unsigned>(_mm256_movemask_ps(mask.high)) << 8;
}

Mask signs_of(const Ints& a) { return {_mm256_castsi256_ps(a.low), _mm256_castsi256_ps(a.high)}; }

unsigned negative_lanes(const Ints& a) { return bits_of(signs_of(a)); }

Mask without_negative(const Mask& mask, const Ints& a) {
    const Mask negative = signs_of(a);
    return {_mm256_andnot_ps(negative.low, mask.low), _mm256_andnot_ps(negative.high, mask.high)};
}

Ints splat(std::int32_t value) { return {_mm256_set1_epi32(value), _mm256_set1_epi32(value)}; }

Ints load(const std::int32_t* values) {
    const auto* const at = reinterpret_cast<const __m256i*>(values);
    return {_mm256_load_si256(at), _mm256_load_si256(at + 1)};
}

void store(std::int32_t* to, const Ints& values) {
    auto* const at = reinterpret_cast<__m256i*>(to);
    _mm256_store_si256(at, values.low);
    _mm256_store_si256(at + 1, values.high);
}

Ints operator+(const Ints& a, const Ints& b) {
    return {_mm256_add_epi32(a.low, b.low), _mm256_add_epi32(a.high, b.high)};
}

Ints operator*(const Ints& a, std::int32_t b) {
    const __m256i factor = _mm256_set1_epi32(b);
    return {_mm256_mullo_epi32(a.low, factor), _mm256_mullo_epi32(a.high, factor)};
}

Ints operator|(const Ints& a, const Ints& b) {
    return {_mm256_or_si256(a.low, b.low), _mm256_or_si256(a.high, b.high)};
}

/// `set` with `bit` besides where a value is not negative.
Ints with_bit_where_not_negative(const Ints& set, std::int32_t bit, const Ints& values) {
    const __m256i bits = _mm256_set1_epi32(bit);
    const auto half = [&](const __m256i& of_set, const __m256i& of_values) {
        return _mm256_or_si256(of_set, _mm256_andnot_si256(_mm256_srai_epi32(of_values, 31), bits));
    };
    return {half(set.low, values.low), half(set.high, values.high)};
}

Doubles splat(double value) {
    const __m256d part = _mm256_set1_pd(value);
    return {{part, part, part, part}};
}

Floats splat(float value) { return {_mm256_set1_ps(value), _mm256_set1_ps(value)}; }

Doubles load(const double* values) {
    return {{_mm256_load_pd(values), _mm256_load_pd(values + 4), _mm256_load_pd(values + 8),
             _mm256_load_pd(values + 12)}};
}

Floats load(const float* values) { return {_mm256_load_ps(values), _mm256_load_ps(values + 8)}; }

/// Four rows of four, `stride` apart.
Floats load_square(const float* values, std::ptrdiff_t stride) {
    const auto pair = [&](std::ptrdiff_t row) {
        const float* const at = values + row * stride;
        return _mm256_set_m128(_mm_loadu_ps(at + stride), _mm_loadu_ps(at));
    };
    return {pair(0), pair(2)};
}

void store(double* to, const Doubles& values) {
    _mm256_store_pd(to, values.part[0]);
    _mm256_store_pd(to + 4, values.part[1]);
    _mm256_store_pd(to + 8, values.part[2]);
    _mm256_store_pd(to + 12, values.part[3]);
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

Doubles operator*(const Doubles& a, const Doubles& b) {
    Doubles d;
    for (int i = 0; i < 4; ++i) d.part[i] = _mm256_mul_pd(a.part[i], b.part[i]);
    return d;
}

Doubles doubles_of(const Ints& a) {
    return {{_mm256_cvtepi32_pd(_mm256_castsi256_si128(a.low)),
             _mm256_cvtepi32_pd(_mm256_extracti128_si256(a.low, 1)),
             _mm256_cvtepi32_pd(_mm256_castsi256_si128(a.high)),
             _mm256_cvtepi32_pd(_mm256_extracti128_si256(a.high, 1))}};
}

/// Clamps whole numbers to [-most, most].
Ints clamped(const Doubles& a, double most) {
    const auto part = [&](int i) {
        const __m256d at_most = _mm256_min_pd(a.part[i], _mm256_set1_pd(most));
        return _mm256_cvttpd_epi32(_mm256_max_pd(at_most, _mm256_set1_pd(-most)));
    };
    return {_mm256_set_m128i(part(1), part(0)), _mm256_set_m128i(part(3), part(2))};
}

Mask greater(const Floats& a, const Floats& b) {
    return {_mm256_cmp_ps(a.low, b.low, _CMP_GT_OQ), _mm256_cmp_ps(a.high, b.high, _CMP_GT_OQ)};
}

Mask not_less(const Floats& a, const Floats& b) {
    return {_mm256_cmp_ps(a.low, b.low, _CMP_GE_OQ), _mm256_cmp_ps(a.high, b.high, _CMP_GE_OQ)};
}

Mask equal(const Floats& a, const Floats& b) {
    return {_mm256_cmp_ps(a.low, b.low, _CMP_EQ_OQ), _mm256_cmp_ps(a.high, b.high, _CMP_EQ_OQ)};
}

Mask operator|(const Mask& a, const Mask& b) {
    return {_mm256_or_ps(a.low, b.low), _mm256_or_ps(a.high, b.high)};
}

/// The lanes of `where` that hold more than `least`.
Mask above(const Mask& where, const std::uint32_t* values, std::uint32_t least) {
    const __m256i bound = _mm256_set1_epi32(static_cast<int>(least));
    const auto half = [&](const std::uint32_t* of, const __m256& mask) {
        const __m256i held = _mm256_load_si256(reinterpret_cast<const __m256i*>(of));
        const __m256i at_most = _mm256_cmpeq_epi32(_mm256_min_epu32(held, bound), held);
        return _mm256_andnot_ps(_mm256_castsi256_ps(at_most), mask);
    };
    return {half(values, where.low), half(values + 8, where.high)};
}

Floats rounded(const Doubles& a) {
    const auto pair = [&](int i) {
        return _mm256_set_m128(_mm256_cvtpd_ps(a.part[i + 1]), _mm256_cvtpd_ps(a.part[i]));
    };
    return {pair(0), pair(2)};
}

Floats select(const Mask& where, const Floats& a, const Floats& b) {
    return {_mm256_blendv_ps(b.low, a.low, where.low), _mm256_blendv_ps(b.high, a.high, where.high)};
}

void store(float* to, const Floats& values) {
    _mm256_store_ps(to, values.low);
    _mm256_store_ps(to + 8, values.high);
}

void put(std::uint32_t* to, const Mask& where, std::uint32_t value) {
    const __m256i values = _mm256_set1_epi32(static_cast<int>(value));
    const auto put_half = [&](std::uint32_t* half, const __m256& mask) {
        auto* const at = reinterpret_cast<__m256*>(half);
        *at = _mm256_blendv_ps(*at, _mm256_castsi256_ps(values), mask);
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

/// Stores the least of each of four times sixteen values.
void store_least_of_four(float* to, const float* values) {
    const auto eight_of = [&](int i) {
        return _mm256_min_ps(_mm256_load_ps(values + i), _mm256_load_ps(values + i + 8));
    };
    const auto halves = [](const __m256& a, const __m256& b) {
        return _mm256_min_ps(_mm256_permute2f128_ps(a, b, 0x20), _mm256_permute2f128_ps(a, b, 0x31));
    };
    const __m256 ab = halves(eight_of(0), eight_of(16)), cd = halves(eight_of(32), eight_of(48));
    const __m256 pairs = _mm256_min_ps(_mm256_unpacklo_ps(ab, cd), _mm256_unpackhi_ps(ab, cd));
    const __m256 least = _mm256_min_ps(pairs, _mm256_permute_ps(pairs, 0b01'00'11'10));  // a c, then b d
    _mm_storeu_ps(to, _mm_unpacklo_ps(_mm256_castps256_ps128(least), _mm256_extractf128_ps(least, 1)));
}

/// Writes index + 16 b for every bit b of the sixteen, and perhaps something after them. Returns how many
/// there are.
int put_bits(std::uint8_t* to, unsigned bits, int index) {
    int count = 0;
    for (; bits != 0; bits &= bits - 1) to[count++] = std::uint8_t(16 * __builtin_ctz(bits) + index);
    return count;
}

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. `to` is a
/// multiple of 16 bytes.
void stream_four(void* to, const void* four) {
    _mm_stream_si128(static_cast<__m128i*>(to), _mm_load_si128(static_cast<const __m128i*>(four)));
}
/// Makes streamed stores visible before another thread may look.
void publish() noexcept { _mm_sfence(); }

/// Sixteen vertices of 16 bytes each, four at a time: x0 y0 N0, x1 y1 N1 ... into x0 x1 ..., y0 y1 ..., N0 N1
/// ...
void put_side_by_side(const SnappedVertex* const (&vertex)[16], std::int32_t* x, std::int32_t* y,
                      double* inverse_depth) {
    const auto load_one = [&](int i) { return _mm_loadu_pd(reinterpret_cast<const double*>(vertex[i])); };
    const __m256i even_then_odd = _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7);
    for (int i = 0; i < 16; i += 4) {
        const __m256d even = _mm256_set_m128d(load_one(i + 2), load_one(i));
        const __m256d odd = _mm256_set_m128d(load_one(i + 3), load_one(i + 1));
        const __m256i points = _mm256_castpd_si256(_mm256_unpacklo_pd(even, odd));
        const __m256i x_then_y = _mm256_permutevar8x32_epi32(points, even_then_odd);
        _mm_store_si128(reinterpret_cast<__m128i*>(x + i), _mm256_castsi256_si128(x_then_y));
        _mm_store_si128(reinterpret_cast<__m128i*>(y + i), _mm256_extracti128_si256(x_then_y, 1));
        _mm256_store_pd(inverse_depth + i, _mm256_unpackhi_pd(even, odd));
    }
}

#include "rasterizer/corners_avx.inl"
#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::avx2, "AVX2", project,          place,        clear,      resolve, publish,
                    draw,      count,  draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::avx2
