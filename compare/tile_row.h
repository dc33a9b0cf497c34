/// Sixteen pixels of a row, side by side: a tile's width.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "frame/frame.h"

namespace zproof {

inline constexpr std::size_t tile_columns = 16;

template <class T>
using TileRowOf = std::array<T, tile_columns>;
using TileRow = TileRowOf<double>;

/// Bit i is column i.
using ColumnMask = std::uint32_t;
inline constexpr ColumnMask all_columns = (ColumnMask{1} << tile_columns) - 1;

/// A row begins at pixel (left, y).
struct RowPlace {
    int left = 0, y = 0;
};

/// Where a > b.
ColumnMask above(const TileRow& a, const TileRow& b);
/// Where a >= 0.
ColumnMask at_least_zero(const TileRow& a);

/// Where `mask` says so, the larger of a and b; elsewhere a.
TileRow raised(const TileRow& a, const TileRow& b, ColumnMask mask);

}  // namespace zproof
