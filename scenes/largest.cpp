#include "scenes/largest.h"

#include <algorithm>
#include <cstring>

namespace zproof {
namespace {

template <typename T>
T largest_of(const unsigned char* numbers, std::size_t count, T mask) {
    T most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        T number;
        std::memcpy(&number, numbers + i * sizeof(T), sizeof(T));
        most = std::max(most, T(number & mask));
    }
    return most;
}

}  // namespace

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] std::uint8_t largest(
    const unsigned char* numbers, std::size_t count, std::uint8_t mask) {
    return largest_of(numbers, count, mask);
}

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] std::uint16_t largest(
    const unsigned char* numbers, std::size_t count, std::uint16_t mask) {
    return largest_of(numbers, count, mask);
}

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] std::uint32_t largest(
    const unsigned char* numbers, std::size_t count, std::uint32_t mask) {
    return largest_of(numbers, count, mask);
}

}  // namespace zproof
