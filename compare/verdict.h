/// What the judge says of a candidate's frame beside a reference's.
#pragma once

#include <array>
#include <cstdint>

#include "compare/class_map.h"
#include "compare/pixel_class.h"
#include "frame/frame.h"
#include "math/bulk.h"

namespace zproof {

/// One renderer's answer at one pixel.
struct Answer {
    PrimitiveId primitive = PrimitiveId::none;
    float camera_depth = background_depth;
};

/// Camera depths that a faultless renderer may report, [low, high], and the true depth at the pixel centre.
struct DepthBound {
    double low = 0, truth = 0, high = 0;  ///< all NaN where the answer is background
};

/// A pixel at which the two frames do not simply agree, with the evidence.
struct Finding {
    int x = 0, y = 0;
    PixelClass verdict = PixelClass::agree;
    Answer candidate, reference;
    double eps_px = 0;            ///< half-side of the square that the candidate's answer was judged in
    DepthBound candidate_depth;   ///< bound for the candidate's own id
    double error_over_bound = 0;  ///< of the candidate's depth; NaN for background
};

/// Distribution of error / bound: bin k counts [k/20, (k+1)/20), the last bin counts everything from 1 up.
using BoundHistogram = std::array<std::uint64_t, 21>;

/// One renderer's errors of one kind held against their bounds.
struct BoundRecord {
    double max_error_over_bound = 0;
    BoundHistogram histogram{};

    bool operator==(const BoundRecord&) const = default;
};

struct Verdict {
    ClassMap classes;
    ClassCounts counts{};
    /// In raster order: from judge() the pixels that fail the gate, from judge_in_full() all that do not
    /// `agree`.
    Bulk<Finding> findings;
    /// Where both answers name the same triangle. Their histograms are empty from judge(), filled in from
    /// judge_with_histograms() and judge_in_full().
    BoundRecord candidate_depth, reference_depth;
    /// Displacement over eps, where the two differ and an answer is lawful by its place but not right at the
    /// centre (compare/truth/displacement.h).
    BoundRecord candidate_edges, reference_edges;
    std::uint64_t reference_defects = 0;  ///< pixels at which the reference's own answer is inadmissible
    std::uint64_t adjudicated = 0;        ///< pixels that needed the admissible set
    std::uint64_t exact = 0;              ///< of those, pixels that needed exact rationals
};

/// Pixels that fail the gate.
std::uint64_t defect_count(const Verdict& verdict);

}  // namespace zproof
