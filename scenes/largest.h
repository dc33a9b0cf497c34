/// The largest of many numbers in a file's bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace zproof {

/// Without its sign, the bits of a float rise as the float does; those of infinity are the least that are not
/// finite, and those of NaN are above them.
constexpr std::uint32_t magnitude_bits = 0x7FFF'FFFF, infinite_bits = 0x7F80'0000;

/// The largest of `count` packed numbers, of whose bits only those in the mask count; 0 for none.
template <typename T>
T largest(const unsigned char* numbers, std::size_t count, T mask = T(-1)) {
    T most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        T number;
        std::memcpy(&number, numbers + i * sizeof(T), sizeof(T));
        most = std::max(most, T(number & mask));
    }
    return most;
}

}  // namespace zproof
