/// A diagnosis as one line of plain text.
#pragma once

#include <string>

#include "compare/diagnosis/diagnosis.h"

namespace zproof {

/// "97.3%", rounded towards 0: "100%" is all of them.
std::string percent(double share);

/// The cause's name, with the number that was fitted: "depth is scaled by a constant: depth is told
/// times 1.1".
std::string named(const Explanation& explanation);

/// How much of the defects a hypothesis explains: "100% of 1,204 defects", or "98.2% of 2,000 of 31,204
/// defects" where only some were asked.
std::string extent_of(const Explanation& explanation, const Diagnosis& diagnosis);

/// "likely cause: the image is flipped in y (explains 100% of 1,204 defects)", or "no cause is certain" with
/// the best that was found.
std::string in_words(const Diagnosis& diagnosis);

}  // namespace zproof
