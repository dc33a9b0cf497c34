/// Pixels adjudicated again, by another rule: claims as a hypothesis reads them.
#pragma once

#include <span>
#include <vector>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// What a hypothesis says of a claim.
struct ClaimCheck {
    bool is_admissible = false;
    /// How much it leaves open there: log2 of the number of answers that it admits, ids times depths. 0 where
    /// that was not asked, or the claim is not admissible.
    double open_bits = 0;
};

enum class CheckDetail {
    admissibility,
    open_bits,  ///< takes several times as long
};

/// Claims and the hypothesis that reads them.
struct HypothesisQuery {
    const Hypothesis* hypothesis = nullptr;
    std::span<const Claim> claims;
    CheckDetail most_detail = CheckDetail::open_bits;  ///< no more is asked than the call asks
};

/// Checks every claim of each query, in order. Queries of one call share one pass over the scene. Runs on all
/// threads; the result does not depend on their number.
std::vector<std::vector<ClaimCheck>> check_claims(const DiagnosisInput& input,
                                                  std::span<const HypothesisQuery> queries,
                                                  CheckDetail detail);

}  // namespace zproof
