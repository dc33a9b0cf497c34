/// Pixels on their way through the first pass.
#pragma once

#include <array>
#include <cstdint>

#include "compare/strips/runs.h"
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
    static constexpr Pixels all = ~Pixels{0};

    /// What one renderer shows, from the first pixel on.
    struct Side {
        const PrimitiveId* primitive = nullptr;
        const float* camera_depth = nullptr;
    };
    static constexpr std::size_t chunk = tile_columns;  ///< pixels that are sorted out together

    int x = 0, y = 0;  ///< of the first
    Side candidate, reference;
    Pixels turns = 1;   ///< the candidate shows another triangle than at the pixel before; the first
    Pixels differ = 0;  ///< the reference shows another triangle than the candidate
    /// Of the candidate's runs, which begin where it turns, in order: places among the laws.
    Values<std::uint32_t> law_of_run;

    /// A triangle that one frame shows at some pixels, by its place among the laws.
    struct Shown {
        std::uint32_t law;
        Pixels pixels;
    };
    /// Several of them; no pixel twice.
    struct ShownOnes {
        Values<Shown> of;
        int count = 0;
    };
    ShownOnes others;  ///< what the reference shows where they differ

    /// The pixels of the first of the runs that begin where it turns; takes it from them.
    static Pixels take_run(Pixels& turns) {
        const Pixels from_first = -(turns & -turns);
        turns &= turns - 1;
        return from_first & ~-(turns & -turns);
    }
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

/// The laws of a strip's pixels, side by side.
struct LawsAlong {
    SpreadValues<std::uint32_t, Strip::width> candidate, reference;
};
LawsAlong laws_along(const Strip& strip);

/// What the candidate shows where the frames differ, run by run.
Strip::ShownOnes candidates_where_they_differ(const Strip& strip);

}  // namespace zproof
