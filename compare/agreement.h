/// The first pass: pixels at which the two frames plainly agree are settled at once, the rest is left open.
#pragma once

#include <atomic>

#include "compare/error_map.h"
#include "compare/open_tiles.h"
#include "compare/witness.h"

namespace zproof {

/// What both depths were held against; sums of integers and maxima, so the order of adding does not matter.
struct Tally {
    BoundRecord candidate, reference;
};

void count(BoundRecord& record, double error_over_bound);
void add(Tally& sum, const Tally& part);

/// The largest ratios that any part of the image has shown so far. Only what work is saved depends on it.
struct LargestSoFar {
    std::atomic<double> candidate = 0, reference = 0;
};

/// Rows [top, bottom) of a view; top is the first of a row of tiles.
struct Rows {
    int top, bottom;
    LargestSoFar& largest;
    bool histograms = false;      ///< whether those of the depths are filled in
    ErrorMaps* errors = nullptr;  ///< where there are some, what these rows of them hold is written
};

/// Opens the pixels that are not settled. What the depths were held against where both name the same
/// triangle.
Tally compare_rows(const Scene& scene, const Witness& candidate, const Witness& reference, const Rows& rows,
                   OpenTiles& open);

}  // namespace zproof
