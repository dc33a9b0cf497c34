/// What a study knows of every pixel of a view, whatever the method.
#pragma once

#include <vector>

#include "filters/study/regions.h"
#include "frame/picture.h"

namespace zproof::study {

/// Planes of one size.
struct ViewEvidence {
    Picture truth;
    Plane<double> half_width;  ///< of the truth's 95 % confidence interval; 0 where it is exact
    Plane<Patch> patches;
    std::vector<Region> regions;  ///< in the order of region_cards()
};

}  // namespace zproof::study
