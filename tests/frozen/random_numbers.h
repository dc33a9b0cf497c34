/// Numbers from a seed, the same with every standard library and on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace zproof::frozen {

/// 2^exponent, for what a double can hold without loss.
constexpr double power_of_two(int exponent) {
    double power = 1;
    for (; exponent > 0; --exponent) power *= 2;
    for (; exponent < 0; ++exponent) power *= 0.5;
    return power;
}

/// Draw in an order that the language fixes: in braces or statement by statement, not as two operands.
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

    /// 0 to count - 1.
    std::uint32_t below(std::uint32_t count) { return std::uint32_t(engine_()) % count; }
    int below(int count) { return int(below(std::uint32_t(count))); }
    double between(double low, double high) {
        return low + (high - low) * (std::uint32_t(engine_()) * 0x1p-32);
    }
    /// Does it happen, once in so many times?
    bool once_in(int count) { return below(count) == 0; }
    template <class T, std::size_t count>
    T one_of(const std::array<T, count>& choices) {
        return choices[below(std::uint32_t(count))];
    }

  private:
    std::mt19937 engine_;
};

}  // namespace zproof::frozen
