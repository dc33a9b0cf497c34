/// The largest of many numbers in a file's bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace zproof {

/// Without its sign, the bits of a float rise as the float does; those of infinity are the least that are not
/// finite, and those of NaN are above them.
constexpr std::uint32_t magnitude_bits = 0x7FFF'FFFF, infinite_bits = 0x7F80'0000;

/// The largest of `count` packed numbers, of whose bits only those in the mask count; 0 for none.
template <typename T>
T largest(const unsigned char* numbers, std::size_t count, T mask = T(-1)) {
    constexpr std::size_t abreast = 16;
    std::array<T, abreast> most{}, some;
    for (; count >= abreast; count -= abreast, numbers += sizeof some) {
        std::memcpy(some.data(), numbers, sizeof some);
        for (std::size_t i = 0; i < abreast; ++i) most[i] = std::max(most[i], T(some[i] & mask));
    }
    some.fill(0);
    if (count > 0) std::memcpy(some.data(), numbers, count * sizeof(T));
    for (std::size_t i = 0; i < abreast; ++i) most[0] = std::max({most[0], most[i], T(some[i] & mask)});
    return most[0];
}

}  // namespace zproof
