/// Sixteen pixels of a row, side by side: a tile's width.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zproof {

inline constexpr std::size_t lane_count = 16;

template <class T>
using LanesOf = std::array<T, lane_count>;
using Lanes = LanesOf<double>;

/// Bit i is lane i.
using LaneMask = std::uint32_t;

/// Lanes begin at pixel (left, y).
struct LaneRow {
    int left = 0, y = 0;
};

}  // namespace zproof
