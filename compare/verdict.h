/// What the judge says of a candidate's frame beside a reference's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/finding.h"
#include "frame/frame.h"

namespace zproof {

/// Distribution of error / bound: bin k counts [k/20, (k+1)/20), the last bin counts everything from 1 up.
using BoundHistogram = std::array<std::uint64_t, 21>;

/// One renderer's errors of one kind held against their bounds.
struct BoundRecord {
    double max_error_over_bound = 0;
    BoundHistogram histogram{};

    bool operator==(const BoundRecord&) const = default;
};

/// Counts one more error.
void count(BoundRecord& record, double error_over_bound);
void add(BoundRecord& sum, const BoundRecord& part);

/// |depth - truth| / bound of each frame's own ids; NaN where that asks nothing: background, an id that does
/// not exist, a depth that is NaN. In double, so at 1 only the judge's word counts.
struct ErrorMaps {
    Plane<float> candidate, reference;
};

struct Verdict {
    Plane<PixelClass> classes;
    ClassCounts counts{};
    std::vector<Finding> findings;  ///< in raster order: the pixels that were asked for (JudgeOptions)
    BoundRecord candidate_depth, reference_depth;  ///< where both answers name the same triangle
    /// Displacement over eps, where the two differ and an answer is admissible by its place but not right at
    /// the centre (compare/admissible/displacement.h).
    BoundRecord candidate_edges, reference_edges;
    std::uint64_t reference_defects = 0;  ///< pixels at which the reference's own answer is inadmissible
    std::uint64_t adjudicated = 0;        ///< pixels that needed the admissible set
    std::uint64_t exact = 0;              ///< of those, pixels that needed exact rationals
    /// Pixels of whose depth nothing is promised, and that agree, of whose attributes nothing is.
    std::uint64_t open_depths = 0, open_attributes = 0;
    std::optional<ErrorMaps> errors;      ///< where they were asked for
};

/// Pixels that fail the gate.
std::uint64_t defect_count(const Verdict& verdict);

/// Pixels of which nothing can be said.
inline std::uint64_t undecidable_count(const Verdict& verdict) {
    return verdict.counts[std::size_t(PixelClass::undecidable)];
}

}  // namespace zproof
