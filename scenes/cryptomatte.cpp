#include "scenes/cryptomatte.h"

#include <bit>

namespace zproof {
namespace {

constexpr std::uint32_t c1 = 0xCC9E2D51, c2 = 0x1B873593;

/// Up to four bytes, the first one lowest.
std::uint32_t word_of(std::string_view bytes) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        word |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
    return word;
}

std::uint32_t scrambled(std::uint32_t word) { return std::rotl(word * c1, 15) * c2; }

}  // namespace

std::uint32_t murmur_hash3(std::string_view bytes) {
    std::uint32_t hash = 0;
    std::size_t at = 0;
    for (; bytes.size() - at >= 4; at += 4)
        hash = std::rotl(hash ^ scrambled(word_of(bytes.substr(at, 4))), 13) * 5 + 0xE6546B64;
    hash ^= scrambled(word_of(bytes.substr(at)));
    hash ^= std::uint32_t(bytes.size());
    hash = (hash ^ hash >> 16) * 0x85EBCA6B;
    hash = (hash ^ hash >> 13) * 0xC2B2AE35;
    return hash ^ hash >> 16;
}

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash3(name), exponent = hash >> 23 & 0xFF;
    return exponent == 0 || exponent == 0xFF ? hash ^ 1u << 23 : hash;
}

}  // namespace zproof
