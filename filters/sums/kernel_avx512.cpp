// Sixteen lanes: AVX-512.
#include <immintrin.h>

#include <utility>

#include "filters/sums/kernel.h"

namespace zproof::texture::sums::avx512 {
namespace {

typedef std::uint32_t Lanes __attribute__((vector_size(64)));

Lanes widened(const std::uint8_t* codes) {
    return reinterpret_cast<Lanes>(
        _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(codes))));
}
Lanes widened(const std::uint16_t* codes) {
    return reinterpret_cast<Lanes>(
        _mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(codes))));
}

void stream(std::uint32_t* to, Lanes sums) {
    _mm512_stream_si512(reinterpret_cast<__m512i*>(to), reinterpret_cast<__m512i>(sums));
}
void fence() { _mm_sfence(); }

#include "filters/sums/rows.inl"

}  // namespace

const Kernel kernel{"AVX-512", add, add, sum, sum};

}  // namespace zproof::texture::sums::avx512
