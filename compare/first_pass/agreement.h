/// The first pass: pixels at which the two frames plainly agree are settled at once, the rest is left open.
#pragma once

#include "compare/first_pass/error_map.h"
#include "compare/first_pass/open_tiles.h"
#include "compare/witness.h"

namespace zproof {

/// What both depths were held against; sums of integers and maxima, so the order of adding does not matter.
struct Tally {
    BoundRecord candidate, reference;
};

void count(BoundRecord& record, double error_over_bound);
void add(Tally& sum, const Tally& part);

/// What is wanted of the depths beside their largest errors.
struct Wanted {
    bool histograms = false;
    ErrorMaps* errors = nullptr;  ///< of the frames' size, filled in where there are some
};

/// Opens the pixels that are not settled. What the depths were held against where both name the same
/// triangle. On all threads.
Tally compare_frames(const Scene& scene, const Witness& candidate, const Witness& reference,
                     const Wanted& wanted, OpenTiles& open);

}  // namespace zproof
