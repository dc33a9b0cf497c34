/// Raster coordinates to fixed point: with 8 sub-pixel bits, 24.8 numbers in steps of 1/256 px.
#pragma once

#include <cstdint>

#include "frame/precision.h"

namespace zproof::rasterizer {

/// A point on the sub-pixel grid, in grid steps.
struct SnappedPoint {
    std::int32_t x = 0, y = 0;
    bool operator==(const SnappedPoint&) const = default;
};

/// The grid of vertices and samples.
struct SubpixelGrid {
    int bits = 8;                      ///< grid step is 2^-bits px
    std::int32_t sample_offset = 128;  ///< from a pixel's upper left corner to its sample, grid steps
    Snap snapping = Snap::nearest;

    [[gnu::always_inline]] constexpr std::int32_t steps_per_pixel() const { return std::int32_t{1} << bits; }

    /// Coordinate within +-(guard_band_px(bits) + 1), px. Scaling by a power of two is exact; only the snap
    /// rounds: to even by the rule of IEEE 754, in a sum that falls where doubles are whole numbers (|steps|
    /// < 2^51); the subtraction is exact. No instruction set is asked for, and there is no branch.
    [[gnu::always_inline]] constexpr std::int32_t snap(double coordinate_px) const {
        const double steps = coordinate_px * steps_per_pixel();
        const double whole_numbers = snapping == Snap::nearest ? 0x1.8p52 : 0;
        return static_cast<std::int32_t>((steps + whole_numbers) - whole_numbers);
    }
    /// The place where a pixel of this column or row is sampled.
    [[gnu::always_inline]] constexpr std::int32_t sample(int pixel) const {
        return pixel * steps_per_pixel() + sample_offset;
    }
    /// The first pixel sampled at or after a coordinate, and the last sampled at or before it (shifts floor).
    [[gnu::always_inline]] constexpr int first_pixel_from(std::int32_t c) const {
        return (c - sample_offset + steps_per_pixel() - 1) >> bits;
    }
    [[gnu::always_inline]] constexpr int last_pixel_until(std::int32_t c) const {
        return (c - sample_offset) >> bits;
    }
};

}  // namespace zproof::rasterizer
