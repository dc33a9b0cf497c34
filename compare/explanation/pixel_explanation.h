/// The explanation of one pixel.
#pragma once

#include <array>
#include <vector>

#include "compare/admissible/admissibility.h"
#include "compare/bounds/pixel_coord.h"
#include "compare/verdict.h"

namespace zproof {

/// A triangle that comes near the pixel, as the judge sees it.
struct Candidate {
    PrimitiveId primitive = PrimitiveId::none;
    /// Signed distance of the pixel's centre from each edge (0: v1v2, 1: v2v0, 2: v0v1), in 1/256 px;
    /// positive inside; all NaN where the triangle is seen edge-on.
    std::array<double, 3> edge_distance{};
    DepthBound depth;
    Decision decision;
};

struct PixelExplanation {
    Finding finding;
    Decision candidate, reference;  ///< both answers, each judged by its own renderer's precision
    bool ids_differ = false;        ///< otherwise the decisions were not needed and say nothing
    std::vector<Candidate>
        candidates;       ///< triangles within eps of the centre, nearest first; candidate's precision
    Decision background;  ///< would background have been admissible?
    /// Triangles nearby, none nearer than the candidates, that were not asked about: the work was spent.
    std::size_t left_out = 0;
};

}  // namespace zproof
