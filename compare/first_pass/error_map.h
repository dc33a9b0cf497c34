/// How much of its depth bound a renderer uses up, pixel by pixel: for pictures and histograms.
#pragma once

#include "compare/judge.h"

namespace zproof {

/// |depth - truth| / bound of the frame's own ids; NaN where that asks nothing: background, an id that does
/// not exist, a depth that is NaN. In double, so at 1 only the judge's word counts. On the threads of the
/// surrounding tbb::task_arena. The frame must have the view's size (std::invalid_argument otherwise).
Plane<float> error_over_bound(const Scene& scene, const View& view, const Testimony& testimony);

/// The same of both renderers.
struct ErrorMaps {
    Plane<float> candidate, reference;
};

}  // namespace zproof
