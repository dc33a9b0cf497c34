/// The smallest promise under which every pixel of a frame is admissible (docs/fit.md).
#pragma once

#include <cstdint>
#include <vector>

#include "frame/frame.h"
#include "frame/precision.h"
#include "measure/fit/depth_error.h"

namespace zproof::measure {

/// A pixel that the least promise of the others does not explain.
struct LeftOut {
    PixelCoord pixel;
    Answer answer;
    enum class Reason {
        alone_by_place,     ///< it needs more than ten times the eps of all others
        alone_by_depth,     ///< the same of the depth error
        beyond_all_places,  ///< no eps up to 2^most_octave px explains it
        beyond_all_depths,  ///< no depth error up to 2^most_octave explains it
        no_answer,          ///< NaN, a negative depth, an id that does not exist
    };
    Reason reason = Reason::no_answer;
};

/// The greatest error among depths, and where it is.
struct LeastDepth {
    DepthError error;
    PixelCoord decided_by;
};

/// The depth error that would be left if more displacement were granted.
struct DepthBeside {
    double eps_px = 0;
    DepthError error;
};

struct ViewFit {
    std::uint64_t pixels = 0;
    OctaveCounts eps_px, depth_relative;  ///< of the answers that are one: what each needs
    std::uint64_t seams = 0;  ///< pixels that show a seam of the scene: triangles that touch, no shared edge
    std::uint64_t gaps = 0;   ///< pixels that show a gap between triangles that share an edge
    LeastEps eps;             ///< of all pixels but those that are left out
    LeastDepth depth;         ///< the same
    std::vector<DepthBeside> trade;  ///< by twice, 4 and 8 times the promised eps
    LeastEps eps_of_alone;           ///< of those that stand alone by place
    LeastDepth depth_of_alone;       ///< of those that stand alone by depth
    std::vector<LeftOut> left_out;   ///< reason by reason, each in raster order
    /// What the figures come to, rounded up to three digits.
    BoundedPrecision promise;
    std::uint64_t defects = 0;  ///< pixels that the judge calls defects under the promise
    bool is_verified = false;   ///< are those all among the pixels that are left out?
};

/// Fits a frame of the view's size (std::invalid_argument otherwise) on the threads of the surrounding
/// tbb::task_arena; the result does not depend on their number.
ViewFit fit(const Scene& scene, const View& view, const Frame& frame);

/// A promise that covers both.
BoundedPrecision cover(const BoundedPrecision& a, const BoundedPrecision& b);

}  // namespace zproof::measure
