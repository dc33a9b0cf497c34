// Eight lanes: AVX-512.
#include <immintrin.h>

#include <limits>
#include <utility>

#include "filters/reads/kernel.h"

namespace zproof::texture::reads::avx512 {
namespace {

constexpr int lanes = 8;
typedef double Lanes __attribute__((vector_size(64)));
typedef std::int64_t Bits __attribute__((vector_size(64)));

Lanes gather(const double* numbers, const std::int32_t* index) {
    const __m256i at = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    return _mm512_i32gather_pd(_mm256_slli_epi32(at, 3), numbers, 8);
}

Bits product(Bits a, Bits b) {
    return reinterpret_cast<Bits>(
        _mm512_mul_epu32(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b)));
}

Lanes whole_below(Lanes x) { return _mm512_roundscale_pd(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC); }

#include "filters/reads/taps.inl"

#include "filters/reads/colour.inl"

#include "filters/reads/block.inl"

#include "filters/reads/lines.inl"

}  // namespace

const Kernel kernel{"AVX-512", find_taps, add_up, add_lines};

}  // namespace zproof::texture::reads::avx512
