/// What single precision needs of a triangle to tell which bins its depths' errors over their bounds fall
/// into (docs/truth.md, "Estimates").
#pragma once

#include "compare/depth_law.h"

namespace zproof {

/// Bins are that many to a ratio of 1.
inline constexpr float bins_per_ratio = 20;

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

}  // namespace zproof
