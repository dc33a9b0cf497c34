/// The bins that depths' errors over their bounds fall into, in single precision where that is certain: the
/// way of most pixels (docs/truth.md, "Estimates").
#pragma once

#include "compare/depth_law.h"
#include "compare/runs.h"
#include "compare/tile_row.h"

namespace zproof {

/// One triangle, as both renderers have it. A place along the depth axis, `w`, is nearness for perspectives
/// and depth for parallel projections; it is affine in the image.
struct DepthEstimate {
    /// What one renderer's law says, folded together and rounded.
    struct Bound {
        float shift_base, most_shift, nearness_error;
        float beyond;  ///< how far past its corners' depths a renderer may go: 0, or very far
        float factor, absolute;
        float unsure;                   ///< what a ratio times 20 may be off by
        float top;                      ///< below it, with `unsure` added, the depth is lawful for certain
        float shift_per, plane_offset;  ///< 0 for parallel projections
    };

    /// Errors so small that no more need be known: |error| times (w + shift) for perspectives, |error| for
    /// parallel projections, is at most slope w + room. Then the depth is lawful, in the first bin, and not
    /// the largest, for certain. Never so where slope and room are negative.
    struct Quiet {
        float shift = 0, slope = -1, room = -1;
        float unused = 0;
    };

    double w_per_x, w_per_y, w_offset;
    double least, most;  ///< of w: the corners', widened
    Bound candidate, reference;
    Quiet candidate_quiet, reference_quiet;
    bool is_usable = false;
};

/// The largest ratios so far, times 20, rounded down.
struct KnownLargest {
    float candidate = 0, reference = 0;
};

/// Not usable where single precision says too little. What is quiet has to be so beside `known`.
DepthEstimate estimate_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                          const KnownLargest& known);

/// Of sixteen pixels.
struct EstimatedRow {
    struct Side {
        TileRowOf<std::int32_t> bin;  ///< of the error over the bound, as BoundHistogram has it
        ColumnMask certain = 0;       ///< where the depth is lawful and that is its bin
        ColumnMask may_exceed = 0;    ///< where it may be more than the largest
        bool is_quiet = false;        ///< what was asked about is, all of it
    };
    Side candidate, reference;
};

/// The camera depths that both frames hold in the pixels from `place` on.
struct DepthsOfBoth {
    RowPlace place;
    const float *candidate, *reference;
};

/// What is asked about them.
struct Asked {
    Projection projection;
    KnownLargest known;               ///< no less than when the estimates were made
    ColumnMask pixels = all_columns;  ///< of the others nothing need be certain
    /// Whose errors may be quiet, all of them: which is asked first. Where some are not, that was for
    /// nothing.
    struct {
        bool candidate = true, reference = true;
    } may_be_quiet{};
};

/// As if both frames showed the triangle there. Nothing is certain of one that is not usable.
void estimate(const DepthEstimate& triangle, const Asked& asked, const DepthsOfBoth& depths,
              EstimatedRow& estimated);

/// Of a tile's columns.
using Estimates = SpreadValues<const DepthEstimate*, tile_columns>;

/// The same, each by its own triangle: `ours` is what the candidate shows, `theirs` the reference; one object
/// where both show the same.
struct EstimatesOfBoth {
    const Estimates &ours, &theirs;
};
void estimate(const EstimatesOfBoth& triangles, const Asked& asked, const DepthsOfBoth& depths,
              EstimatedRow& estimated);

}  // namespace zproof
