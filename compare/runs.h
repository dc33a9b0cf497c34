/// Values that stay the same along runs of pixels.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace zproof {

/// Spreads a value over each run of `width` pixels. Bit i of `turns` says that a run begins at pixel i: bit 0
/// must be set, and none from `width` on. value_at(i) is asked once for each run, with its first pixel.
template <std::size_t width, class ValueAt>
auto spread_over_runs(std::uint64_t turns, const ValueAt& value_at) {
    using Value = decltype(value_at(std::size_t{0}));
    constexpr std::size_t step = 8;
    std::array<Value, width + step> values;  // written beyond a run's end, where the next one begins
    values.fill(value_at(0));
    for (turns &= turns - 1; turns != 0;) {
        const auto first = std::size_t(std::countr_zero(turns));
        turns &= turns - 1;
        const std::size_t end = std::min(std::size_t(std::countr_zero(turns)), width);
        const Value value = value_at(first);
        for (std::size_t i = first; i < end; i += step) std::fill_n(values.begin() + i, step, value);
    }
    std::array<Value, width> spread;
    std::copy_n(values.begin(), width, spread.begin());
    return spread;
}

}  // namespace zproof
