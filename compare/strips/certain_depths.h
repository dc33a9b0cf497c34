/// Depths that are lawful for certain: the way of most pixels (docs/truth.md, "Tolerances").
#pragma once

#include <limits>

#include "compare/bounds/depth_tolerance.h"
#include "compare/tile_row.h"

namespace zproof {

/// Of a row's sixteen pixels, some by what either frame shows there.
struct ColumnsOfBoth {
    ColumnMask candidate = 0, reference = 0;
};

/// The camera depths that both frames hold in the pixels from `place` on.
struct DepthsOfBoth {
    RowPlace place;
    const float *candidate, *reference;
};

/// Errors over their bounds that are not to be exceeded.
struct AtMost {
    double candidate = std::numeric_limits<double>::infinity(),
           reference = std::numeric_limits<double>::infinity();
};

/// As if both frames showed that triangle everywhere: where the depth is lawful and its error over the bound
/// is at most that much, both for certain. Next to its corners nothing is, unless it is told what holds
/// there.
ColumnsOfBoth certain_depths(const DepthTolerance& triangle, const CornerTolerance* next_to_corners,
                             Projection projection, const DepthsOfBoth& depths, const AtMost& at_most);

}  // namespace zproof
