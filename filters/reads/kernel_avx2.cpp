// Four lanes: AVX2.
#include <immintrin.h>

#include <limits>
#include <utility>

#include "filters/reads/kernel.h"

namespace zproof::texture::reads::avx2 {
namespace {

constexpr int lanes = 4;
typedef double Lanes __attribute__((vector_size(32)));
typedef std::int64_t Bits __attribute__((vector_size(32)));

Lanes gather(const double* numbers, const std::int32_t* index) {
    const __m128i at = _mm_loadu_si128(reinterpret_cast<const __m128i*>(index));
    return _mm256_i32gather_pd(numbers, _mm_slli_epi32(at, 3), 8);
}

Bits product(Bits a, Bits b) {
    return reinterpret_cast<Bits>(
        _mm256_mul_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
}

Lanes whole_below(Lanes x) { return _mm256_floor_pd(x); }

#include "filters/reads/taps.inl"

#include "filters/reads/colour.inl"

#include "filters/reads/block.inl"

#include "filters/reads/lines.inl"

}  // namespace

const Kernel kernel{"AVX2", find_taps, add_up, add_lines};

}  // namespace zproof::texture::reads::avx2
