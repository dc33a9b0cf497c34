// Four lanes: AVX2.
#include <immintrin.h>

#include <limits>

#include "texture/reads/kernel.h"

namespace zproof::texture::reads::avx2 {
namespace {

constexpr int lanes = 4;
typedef double Lanes __attribute__((vector_size(32)));
typedef std::int64_t Bits __attribute__((vector_size(32)));

Lanes chosen(const double* numbers, const std::int32_t* index) {
    const __m128i at = _mm_loadu_si128(reinterpret_cast<const __m128i*>(index));
    return _mm256_i32gather_pd(numbers, _mm_add_epi32(_mm_add_epi32(at, at), at), 8);
}

#include "texture/reads/colour.inl"
#include "texture/reads/kernel.inl"

}  // namespace

const Kernel kernel{"AVX2", find_taps, add_up};

}  // namespace zproof::texture::reads::avx2
