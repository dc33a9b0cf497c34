/// Values that stay the same along runs of pixels.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace zproof {

/// Room for values of `width` pixels, and for what is written beyond the last run's end.
constexpr std::size_t run_step = 8;
template <class Value, std::size_t width>
using SpreadValues = std::array<Value, width + run_step>;

/// Spreads a value over each run of `width` pixels. Bit i of `turns` says that a run begins at pixel i: bit 0
/// must be set, and none from `width` on. value_at(i) is asked once for each run, with its first pixel.
template <std::size_t width, class Value, class ValueAt>
void spread_over_runs(std::uint64_t turns, const ValueAt& value_at, SpreadValues<Value, width>& values) {
    values.fill(value_at(0));
    for (turns &= turns - 1; turns != 0;) {
        const auto first = std::size_t(std::countr_zero(turns));
        turns &= turns - 1;
        const std::size_t end = std::min(std::size_t(std::countr_zero(turns)), width);
        const Value value = value_at(first);
        for (std::size_t i = first; i < end; i += run_step)
            std::fill_n(values.begin() + std::ptrdiff_t(i), run_step, value);
    }
}

}  // namespace zproof
