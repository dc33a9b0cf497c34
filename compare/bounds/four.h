/// Four doubles side by side. A formula that is a template over its number type gives each of four triangles
/// the bits that it gives one in double: every lane does the same operations in the same order. To be called
/// where everything is inlined ([[gnu::flatten]]), for how vectors are passed depends on the instruction set.
/// So does how they are aligned: what keeps some where others read them is alignas(four_alignment).
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace zproof {

using Four = double __attribute__((vector_size(32)));
inline constexpr std::size_t four_count = 4;
inline constexpr std::size_t four_alignment = sizeof(Four);

template <class Number>
[[gnu::always_inline]] inline Number absolute(const Number& a) {
    if constexpr (std::is_same_v<Number, Four>) {
        using Bits = std::int64_t __attribute__((vector_size(32)));
        return Four(Bits(a) & INT64_MAX);  // the same bits; std::bit_cast is a function, inlined or not
    } else {
        return std::abs(a);
    }
}

/// b only where it is larger, as std::max.
template <class Number>
[[gnu::always_inline]] inline Number larger(const Number& a, const Number& b) {
    return a < b ? b : a;
}
/// b only where it is smaller, as std::min.
template <class Number>
[[gnu::always_inline]] inline Number smaller(const Number& a, const Number& b) {
    return b < a ? b : a;
}
/// As std::clamp.
template <class Number>
[[gnu::always_inline]] inline Number held_between(const Number& a, const Number& low, const Number& high) {
    const Number raised = a < low ? low : a;
    return high < raised ? high : raised;
}

/// Is it said of every lane?
template <class Lanes>
[[gnu::always_inline]] inline bool holds_in_all(const Lanes& of_four) {
    return (of_four[0] & of_four[1] & of_four[2] & of_four[3]) != 0;
}
template <class Lanes>
[[gnu::always_inline]] inline bool holds_in_any(const Lanes& of_four) {
    return (of_four[0] | of_four[1] | of_four[2] | of_four[3]) != 0;
}

/// The same in every lane.
template <class Number>
[[gnu::always_inline]] inline Number everywhere(double a) {
    if constexpr (std::is_same_v<Number, Four>)
        return Four{a, a, a, a};
    else
        return Number(a);
}

}  // namespace zproof
