/// The bins that depths' errors over their bounds fall into, in single precision where that is certain: the
/// way of most pixels (docs/truth.md, "Estimates").
#pragma once

#include "compare/depth_law.h"
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

    double w_per_x, w_per_y, w_offset;
    double least, most;  ///< of w: the corners', widened
    Bound candidate, reference;
    bool is_usable = false;
};

struct EstimateRow;  // compare/estimate_row.h

/// Not usable where single precision says too little.
DepthEstimate estimate_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection);

/// Of sixteen pixels.
struct EstimatedRow {
    struct Side {
        TileRowOf<std::int32_t> bin;  ///< of the error over the bound, as BoundHistogram has it
        ColumnMask certain = 0;       ///< where the depth is lawful and that is its bin
        ColumnMask may_exceed = 0;    ///< where it may be more than the largest
    };
    Side candidate, reference;
};

/// The largest ratios so far, times 20, rounded down.
struct KnownLargest {
    float candidate = 0, reference = 0;
};

/// The camera depths that both frames hold in the pixels from `place` on.
struct DepthsOfBoth {
    RowPlace place;
    const float *candidate, *reference;
};

/// As if both frames showed the triangle there. Nothing is certain of one that is not usable.
void estimate(const DepthEstimate& triangle, Projection projection, const DepthsOfBoth& depths,
              const KnownLargest& known, EstimatedRow& estimated);

/// The same, each by its own triangle.
void estimate(const EstimateRow& triangles, Projection projection, const DepthsOfBoth& depths,
              const KnownLargest& known, EstimatedRow& estimated);

}  // namespace zproof
