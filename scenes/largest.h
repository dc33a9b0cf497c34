/// The largest of many numbers in a file's bytes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace zproof {

/// Without its sign, the bits of a float rise as the float does; those of infinity are the least that are not
/// finite, and those of NaN are above them.
constexpr std::uint32_t magnitude_bits = 0x7FFF'FFFF, infinite_bits = 0x7F80'0000;

/// The largest of `count` packed numbers, of whose bits only those in the mask count; 0 for none.
std::uint8_t largest(const unsigned char* numbers, std::size_t count, std::uint8_t mask);
std::uint16_t largest(const unsigned char* numbers, std::size_t count, std::uint16_t mask);
std::uint32_t largest(const unsigned char* numbers, std::size_t count, std::uint32_t mask);

}  // namespace zproof
