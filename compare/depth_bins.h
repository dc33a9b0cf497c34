/// The bins that depths' errors over their bounds fall into, in single precision where that is certain: the
/// way of most pixels (docs/truth.md, "Estimates").
#pragma once

#include "compare/estimate_row.h"

namespace zproof {

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
    /// Whose errors may be quiet, all of them: that is asked first, and where some are not, for nothing.
    struct Quiet {
        bool candidate = true, reference = true;
    };
    Quiet may_be_quiet{};
};

/// As if both frames showed the triangle there. Nothing is certain of one that is not usable.
void estimate(const DepthEstimate& triangle, const Asked& asked, const DepthsOfBoth& depths,
              EstimatedRow& estimated);

/// The same, each by its own triangle: `ours` is what the candidate shows, `theirs` the reference; one object
/// where both show the same.
struct EstimatesOfBoth {
    const Estimates &ours, &theirs;
};
void estimate(const EstimatesOfBoth& triangles, const Asked& asked, const DepthsOfBoth& depths,
              EstimatedRow& estimated);

}  // namespace zproof
