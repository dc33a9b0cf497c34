/// Pixels on their way through the first pass.
#pragma once

#include <array>
#include <cstdint>

#include "compare/runs.h"
#include "compare/tile_row.h"
#include "frame/frame.h"

namespace zproof {

/// 64 pixels of a row, as both frames show them. It looks into the frames.
struct Strip {
    static constexpr std::size_t width = 64;
    template <class T>
    using Values = std::array<T, width>;
    /// Bit i is pixel i.
    using Pixels = std::uint64_t;

    /// What one renderer shows.
    struct Side {
        const PrimitiveId* primitive = nullptr;  ///< of the first pixel, and so on
        const float* camera_depth = nullptr;     ///< the same
        SpreadValues<std::uint32_t, width> law;  ///< of the triangle: a place among the laws
    };
    static constexpr std::size_t chunk = tile_columns;  ///< pixels that are sorted out together

    int x = 0, y = 0;           ///< of the first
    Side candidate, reference;  ///< the reference's laws are unwritten where the frames nowhere differ
    Pixels turns;               ///< the candidate shows another triangle than at the pixel before; the first
    Pixels differ;              ///< the reference shows another triangle than the candidate

    /// In both frames, all over.
    bool is_of_one_id() const { return turns == 1 && differ == 0; }

    /// Of a chunk, which begins at pixel `first`.
    static ColumnMask in_chunk(Pixels pixels, std::size_t first) {
        return ColumnMask(pixels >> first) & all_columns;
    }
};

/// What is found of a strip.
struct SortedStrip {
    static constexpr std::uint32_t all_sorted = (1u << Strip::width / Strip::chunk) - 1;

    /// Error / bound, or `unsettled`; of chunks that were sorted otherwise, unwritten.
    struct Ratios {
        Strip::Values<double> candidate, reference;
    };
    Ratios ratio;
    std::uint32_t sorted = 0;  ///< bit k: what becomes of the pixels from k * chunk on is known already
    /// Of each chunk: to be looked at by themselves, neither settled nor bare in both.
    std::array<ColumnMask, Strip::width / Strip::chunk> open;
    std::array<ColumnMask, Strip::width / Strip::chunk> lawful;  ///< of those: both depths are so for certain
};

/// Fills in where the candidate turns to another triangle and where the frames differ.
void compare_ids(Strip& strip);

}  // namespace zproof
