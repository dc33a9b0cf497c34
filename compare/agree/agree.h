/// The first tier: looks at every pixel once. Where both frames name the same triangle, each at a depth that
/// is within its bound for certain, they agree; every other pixel is undecided.
#pragma once

#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "compare/rendered_frame.h"
#include "compare/verdict.h"

namespace zproof {

struct UndecidedPixel {
    PixelCoord place;
    /// Is either answer a triangle whose depth is admissible for certain, or background?
    bool are_depths_admissible = false;
    /// Is the candidate's id undecided: do ids differ, or does the reference's prove nothing (docs/truth.md)?
    bool is_id_undecided = true;
};

struct Agreement {
    BoundRecord candidate_depth, reference_depth;  ///< where ids are the same and depths admissible
    std::vector<UndecidedPixel> undecided;         ///< in raster order
};

/// Runs on the threads of the surrounding tbb::task_arena; the result does not depend on their number. Fills
/// in the maps of errors where there are some: pixels without an error hold NaN.
/// `is_unproven` is 1 where the reference proves nothing (adjudicate/unproven_pixels.h).
Agreement find_agreement(const FramePair& frames, const Plane<std::uint8_t>& is_unproven, ErrorMaps* errors);

}  // namespace zproof
