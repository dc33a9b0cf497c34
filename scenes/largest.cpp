#include "scenes/largest.h"

#include <algorithm>
#include <cstring>

#include "math/widest.h"

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

std::uint8_t largest(const unsigned char* numbers, std::size_t count, std::uint8_t mask) {
    return widest<largest_of<std::uint8_t>>(numbers, count, mask);
}

std::uint16_t largest(const unsigned char* numbers, std::size_t count, std::uint16_t mask) {
    return widest<largest_of<std::uint16_t>>(numbers, count, mask);
}

std::uint32_t largest(const unsigned char* numbers, std::size_t count, std::uint32_t mask) {
    return widest<largest_of<std::uint32_t>>(numbers, count, mask);
}

}  // namespace zproof
