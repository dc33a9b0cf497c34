// Eight lanes: AVX-512.
#include <immintrin.h>

#include <limits>

#include "texture/reads/kernel.h"

namespace zproof::texture::reads::avx512 {
namespace {

constexpr int lanes = 8;
typedef double Lanes __attribute__((vector_size(64)));
typedef std::int64_t Bits __attribute__((vector_size(64)));

Lanes chosen(const double* numbers, const std::int32_t* index) {
    const __m256i at = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    return _mm512_i32gather_pd(_mm256_add_epi32(_mm256_add_epi32(at, at), at), numbers, 8);
}

#include "texture/reads/colour.inl"
#include "texture/reads/kernel.inl"

}  // namespace

const Kernel kernel{"AVX-512", find_taps, add_up};

}  // namespace zproof::texture::reads::avx512
