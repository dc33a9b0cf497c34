/// The judge asked again, with another law: claims as a hypothesis reads them.
#pragma once

#include <cstdint>
#include <span>

#include "compare/hypothesis.h"

namespace zproof {

/// Claims and the hypothesis that reads them.
struct Question {
    const Hypothesis* hypothesis = nullptr;
    std::span<const Claim> claims;
};

/// What the judge says to a question.
struct RetrialOutcome {
    std::uint64_t lawful = 0;  ///< claims that are lawful if the hypothesis holds
    /// Of a lenient hypothesis: how much wider it makes the bounds of the depths in question, as a mean of
    /// logarithms.
    double leniency = 0;
};

/// Puts every question to the judge. Questions of one call share
/// one pass over the scene. Runs on all threads; the outcomes do not depend on their
/// number.
std::vector<RetrialOutcome> retry(const CaseFile& file, std::span<const Question> questions);

}  // namespace zproof
