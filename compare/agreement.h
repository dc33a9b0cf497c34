/// The first pass: pixels at which the two frames plainly agree are settled at once, the rest is left open.
#pragma once

#include <vector>

#include "compare/witness.h"

namespace zproof {

/// What both depths were held against; sums of integers and maxima, so the order of adding does not matter.
struct Tally {
    BoundRecord candidate, reference;
};

void count(BoundRecord& record, double error_over_bound);
void add(Tally& sum, const Tally& part);

/// A pixel that the first pass leaves open, with what it knows already.
struct OpenPixel {
    Finding finding;  ///< verdict: agree until settled
    bool candidate_invalid = false, reference_invalid = false;
    bool candidate_depth_lawful = true, reference_depth_lawful = true;
    double reference_error_over_bound = 0;
};

/// Do both say the same, lawfully?
bool is_settled(const OpenPixel& pixel);

/// What a part of the image holds.
struct Findings {
    std::vector<OpenPixel> open;  ///< in raster order
    Tally tally;                  ///< of the depths at pixels where both name the same triangle
};

/// Compares rows [top, bottom).
Findings compare_rows(const Scene& scene, const View& view, const Witness& candidate,
                      const Witness& reference, int top, int bottom);

/// One pixel, left open whatever it holds.
OpenPixel open_pixel(const Scene& scene, const Witness& candidate, const Witness& reference, int x, int y);

}  // namespace zproof
