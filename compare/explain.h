/// The whole story of one pixel.
#pragma once

#include <string>
#include <vector>

#include "compare/judge.h"

namespace zproof {

/// A triangle that comes near the pixel, as the judge sees it.
struct Candidate {
    PrimitiveId primitive = PrimitiveId::none;
    /// Signed distance of the pixel centre from each edge (0: v1v2, 1: v2v0, 2: v0v1), in 1/256 px; positive inside.
    std::array<double, 3> edge_distance{};
    DepthBound depth;
    bool admissible = false;
};

struct PixelStory {
    Finding finding;
    PixelClass reference_verdict = PixelClass::agree;  ///< the reference judged by itself
    double eps_px = 0;
    std::vector<Candidate> candidates;  ///< nearest first
    bool background_admissible = false;
    bool exact = false;  ///< were exact rationals needed?
};

/// Judges one pixel and keeps the evidence. (x, y) must lie inside the view.
PixelStory explain(const Scene& scene, const View& view, const Testimony& candidate, const Testimony& reference, int x,
                   int y);

/// One sentence for a report: what was answered, what was expected, and why the verdict.
std::string in_words(const Scene& scene, const Finding& finding);

/// The story in full, several lines of plain text ending in a newline.
std::string in_words(const Scene& scene, const PixelStory& story);

}  // namespace zproof
