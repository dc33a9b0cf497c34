/// A verdict as lines of text, so that two judges can be held against each other.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "compare/verdict.h"
#include "tests/frozen/subject.h"

namespace zproof::frozen {

/// Pixels of each class that occurs, by its name.
using CountsByClass = std::map<std::string, std::uint64_t>;

struct VerdictText {
    std::string classes;  ///< size, counts, and the class of every pixel, row by row: "480 agree, 2 edge"
    /// A line for each pixel that fails: place, class, both answers (depths by their bits), eps, the bound of
    /// the candidate's depth, error / bound. Numbers are hexadecimal and exact.
    std::string story;
    CountsByClass counts;  ///< a case that the judge refuses counts as one `refused`

    std::string both() const { return classes + story; }
};

VerdictText text_of(const Verdict& verdict);

/// What the judge says of all cases of the subject, one after the other; "refused" where it does not judge.
VerdictText judged_text(const Subject& subject);

/// SHA-256 over scenes, views, promises and frames of a subject: over all that the judge is told.
std::string input_sha256(const Subject& subject);

}  // namespace zproof::frozen
