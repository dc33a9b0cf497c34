/// How far depths are off, beyond what a displacement explains (docs/fit.md).
#pragma once

#include <span>
#include <vector>

#include "measure/fit/least_eps.h"

namespace zproof::measure {

/// One depth's error in three units; each is an upper bound that our own rounding exceeds by less than
/// 2^-40 of the depth.
struct DepthError {
    double relative = 0;  ///< of the admissible depth that is nearest to it
    double ulps = 0;      ///< float32 steps at the depth shown
    double of_range = 0;  ///< far - near; 0 where far is infinite
};

/// By answer; 0 for background, and for a triangle whose plane double precision does not tell from edge-on,
/// as the judge has it. Infinite where no relative error explains the depth. On the threads of the
/// surrounding tbb::task_arena.
std::vector<DepthError> depth_errors(const Scene& scene, const View& view,
                                     std::span<const PixelAnswer> answers, double eps_px);

}  // namespace zproof::measure
