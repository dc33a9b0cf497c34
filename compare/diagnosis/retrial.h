/// The judge asked again, with another law: claims as a hypothesis reads them.
#pragma once

#include <cstdint>
#include <span>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Claims and the hypothesis that reads them.
struct Question {
    const Hypothesis* hypothesis = nullptr;
    std::span<const Claim> claims;
};

/// For each question, how many of its claims are lawful if its hypothesis holds. Questions of one call share
/// one pass over the scene. Runs on all threads; the counts do not depend on their number.
std::vector<std::uint64_t> count_lawful(const CaseFile& file, std::span<const Question> questions);

/// How much wider the hypothesis makes the bounds of the depths claimed: the mean logarithm.
double leniency_of(const CaseFile& file, const Question& question);

}  // namespace zproof
