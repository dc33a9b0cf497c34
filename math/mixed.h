/// A hash of whole numbers, for noise that is the same everywhere.
#pragma once

#include <cstdint>

namespace zproof {

/// A hash of 64 bits: a step of splitmix64 (Steele, Lea and Flood 2014).
constexpr std::uint64_t mixed(std::uint64_t key) {
    key += 0x9E37'79B9'7F4A'7C15u;
    key = (key ^ (key >> 30)) * 0xBF58'476D'1CE4'E5B9u;
    key = (key ^ (key >> 27)) * 0x94D0'49BB'1331'11EBu;
    return key ^ (key >> 31);
}

}  // namespace zproof
