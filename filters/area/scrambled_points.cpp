#include "filters/area/scrambled_points.h"

namespace zproof::oracle::area {

/// Direction numbers: the identity for component 0, Pascal's triangle modulo 2 for component 1.
std::uint32_t sobol(int component, std::uint32_t index) {
    std::uint32_t fraction = 0;
    for (std::uint32_t direction = 0x8000'0000u; index != 0; index >>= 1) {
        if (index & 1) fraction ^= direction;
        direction = component == 0 ? direction >> 1 : direction ^ (direction >> 1);
    }
    return fraction;
}

std::uint32_t scrambled(std::uint32_t fraction, std::uint64_t seed) {
    constexpr int nested_bits = 16;
    std::uint32_t result = 0;
    for (int bit = 31; bit > 31 - nested_bits; --bit) {
        const std::uint64_t above = bit == 31 ? 0 : fraction >> (bit + 1);
        const std::uint64_t coin = mixed(seed ^ mixed(above * 64 + std::uint64_t(bit))) & 1;
        result |= (((fraction >> bit) & 1) ^ std::uint32_t(coin)) << bit;
    }
    constexpr std::uint32_t rest = (1u << (32 - nested_bits)) - 1;
    return result | (std::uint32_t(mixed(seed ^ mixed(fraction))) & rest);
}

ScrambledPoints::ScrambledPoints() {
    points_.reserve(std::size_t{replicates} * most_points);
    for (std::uint64_t r = 0; r < replicates; ++r)
        for (std::uint32_t i = 0; i < most_points; ++i)
            points_.emplace_back(scrambled(sobol(0, i), mixed(2 * r)),
                                 scrambled(sobol(1, i), mixed(2 * r + 1)));
}

glm::u32vec2 ScrambledPoints::shift(int x, int y, int replicate) {
    const std::uint64_t pixel = (std::uint64_t(std::uint32_t(x)) << 32) | std::uint32_t(y);
    const std::uint64_t word = mixed(mixed(pixel) + std::uint64_t(replicate));
    return {std::uint32_t(word), std::uint32_t(word >> 32)};
}

}  // namespace zproof::oracle::area
