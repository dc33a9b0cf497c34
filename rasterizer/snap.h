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

/// The nearest integer, ties to even, for |value| < 2^51: the sum falls where doubles are whole numbers, so
/// the addition itself rounds by the rule of IEEE 754, and the subtraction is exact. No instruction set is
/// asked for.
constexpr double round_half_even(double value) {
    constexpr double whole_numbers = 0x1.8p52;
    return (value + whole_numbers) - whole_numbers;
}

/// The grid of vertices and samples.
struct SubpixelGrid {
    int bits = 8;                      ///< grid step is 2^-bits px
    std::int32_t sample_offset = 128;  ///< from a pixel's upper left corner to its sample, grid steps
    Snap snapping = Snap::nearest;

    constexpr std::int32_t steps_per_pixel() const { return std::int32_t{1} << bits; }

    /// Coordinate within +-(guard_band_px(bits) + 1), px. Scaling by a power of two is exact; only the snap
    /// rounds.
    constexpr std::int32_t snap(double coordinate_px) const {
        const double steps = coordinate_px * steps_per_pixel();
        return static_cast<std::int32_t>(snapping == Snap::nearest ? round_half_even(steps) : steps);
    }
    /// Where a pixel of this column or row is sampled.
    constexpr std::int32_t sample(int pixel) const { return pixel * steps_per_pixel() + sample_offset; }
    /// The first pixel sampled at or after a coordinate, and the last sampled at or before it (shifts floor).
    constexpr int first_pixel_from(std::int32_t c) const {
        return (c - sample_offset + steps_per_pixel() - 1) >> bits;
    }
    constexpr int last_pixel_until(std::int32_t c) const { return (c - sample_offset) >> bits; }
};

}  // namespace zproof::rasterizer
