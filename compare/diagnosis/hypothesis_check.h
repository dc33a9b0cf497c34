/// Pixels adjudicated again, by another rule: claims as a hypothesis reads them.
#pragma once

#include <cstdint>
#include <span>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Claims and the hypothesis that reads them.
struct HypothesisQuery {
    const Hypothesis* hypothesis = nullptr;
    std::span<const Claim> claims;
};

/// Counts, for each question, the claims that are admissible if its hypothesis holds. Questions of one call
/// share one pass over the scene. Runs on all threads; the counts do not depend on their number.
std::vector<std::uint64_t> count_admissible(const DiagnosisInput& input,
                                            std::span<const HypothesisQuery> hypothesis_queries);

/// How much wider the hypothesis makes the bounds of the depths claimed: the mean logarithm.
double mean_widening(const DiagnosisInput& input, const HypothesisQuery& query);

}  // namespace zproof
