// Eight lanes: AVX2.
#include <immintrin.h>

#include <utility>

#include "filters/sums/kernel.h"

namespace zproof::texture::sums::avx2 {
namespace {

typedef std::uint32_t Lanes __attribute__((vector_size(32)));

Lanes widened(const std::uint8_t* codes) {
    return reinterpret_cast<Lanes>(
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(codes))));
}
Lanes widened(const std::uint16_t* codes) {
    return reinterpret_cast<Lanes>(
        _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(codes))));
}

void stream(std::uint32_t* to, Lanes sums) {
    _mm256_stream_si256(reinterpret_cast<__m256i*>(to), reinterpret_cast<__m256i>(sums));
}
void fence() { _mm_sfence(); }

#include "filters/sums/rows.inl"

}  // namespace

const Kernel kernel{"AVX2", add, add, sum, sum};

}  // namespace zproof::texture::sums::avx2
