/// Structs of doubles, four of them as one of Fours and back. To be called where everything is inlined, as
/// four.h has it.
#pragma once

#include <array>
#include <cstring>
#include <span>

#include "compare/bounds/four.h"

namespace zproof {

/// Writes four structs side by side, two numbers of each at a time.
template <template <class> class Of>
void put_side_by_side(const std::array<const Of<double>*, four_count>& four, Of<Four>& all) {
    using Two = double __attribute__((vector_size(16)));
    constexpr std::size_t fields = sizeof(Of<double>) / sizeof(double);
    static_assert(fields % 2 == 0 && sizeof all == fields * sizeof(Four));
    const auto pair = [](const Of<double>* one, std::size_t i) {
        Two two;
        std::memcpy(&two, reinterpret_cast<const char*>(one) + i * sizeof(double), sizeof two);
        return two;
    };
    const auto put = [&](std::size_t i, const Four& value) {
        std::memcpy(reinterpret_cast<char*>(&all) + i * sizeof value, &value, sizeof value);
    };
    for (std::size_t i = 0; i < fields; i += 2) {
        const Four first = __builtin_shufflevector(pair(four[0], i), pair(four[2], i), 0, 1, 2, 3);
        const Four second = __builtin_shufflevector(pair(four[1], i), pair(four[3], i), 0, 1, 2, 3);
        put(i, __builtin_shufflevector(first, second, 0, 4, 2, 6));
        put(i + 1, __builtin_shufflevector(first, second, 1, 5, 3, 7));
    }
}

/// To each its own, two numbers of all four at a time.
template <template <class> class Of>
void part(const Of<Four>& all, std::span<Of<double>, four_count> four) {
    using Two = double __attribute__((vector_size(16)));
    constexpr std::size_t fields = sizeof(Of<double>) / sizeof(double);
    static_assert(sizeof all == fields * sizeof(Four));
    const char* const from = reinterpret_cast<const char*>(&all);
    const auto to = [&](std::size_t lane, std::size_t i) {
        return reinterpret_cast<char*>(&four[lane]) + i * sizeof(double);
    };
    for (std::size_t i = 0; i + 1 < fields; i += 2) {
        std::array<Four, 2> of_all;
        std::memcpy(&of_all, from + i * sizeof(Four), sizeof of_all);
        const auto put = [&](std::size_t lane, const Two& two) {
            std::memcpy(to(lane, i), &two, sizeof two);
        };
        put(0, __builtin_shufflevector(of_all[0], of_all[1], 0, 4));
        put(1, __builtin_shufflevector(of_all[0], of_all[1], 1, 5));
        put(2, __builtin_shufflevector(of_all[0], of_all[1], 2, 6));
        put(3, __builtin_shufflevector(of_all[0], of_all[1], 3, 7));
    }
    if constexpr (fields % 2 != 0)
        for (std::size_t lane = 0; lane < four_count; ++lane)
            std::memcpy(to(lane, fields - 1), from + (fields - 1) * sizeof(Four) + lane * sizeof(double),
                        sizeof(double));
}

}  // namespace zproof
