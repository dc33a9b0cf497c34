/// What the attack draws by lot: the same numbers on every machine.
#pragma once

#include <cstdint>

namespace zproof::attack {

/// A step of SplitMix64 (Steele, Lea and Flood 2014).
inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    std::uint64_t z = a + 0x9E37'79B9'7F4A'7C15 * (b + 1);
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EB;
    return z ^ (z >> 31);
}

/// -1 or 1, of its own for each number.
inline double sign_of(std::uint64_t lot, unsigned number) { return (lot >> number & 1) != 0 ? 1 : -1; }

}  // namespace zproof::attack
