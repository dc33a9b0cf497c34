/// Every hypothesis that a diagnosis tests, in families. Within a family, and from one to the next, the more
/// specific stands first (docs/diagnosis.md).
#pragma once

#include <vector>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Answers that are none: a depth that is no number, a background that is not told as one.
std::vector<Hypothesis> hypotheses_of_signs(const CaseFile& file);
/// The image is flipped, turned or shifted.
std::vector<Hypothesis> hypotheses_of_place(const CaseFile& file);
/// Depth is told in other units.
std::vector<Hypothesis> hypotheses_of_depth(const CaseFile& file);
/// Ids name other triangles.
std::vector<Hypothesis> hypotheses_of_ids(const CaseFile& file);
/// Another depth test, fill rule, culling or clipping.
std::vector<Hypothesis> hypotheses_of_drawing(const CaseFile& file);
/// Part of the frame is missing or comes from elsewhere.
std::vector<Hypothesis> hypotheses_of_parts(const CaseFile& file);
/// Less precision than was declared, the least loss first.
std::vector<Hypothesis> hypotheses_of_precision(const CaseFile& file);

/// All of them, the more specific first: of two that explain the same, the first is named.
std::vector<Hypothesis> all_hypotheses(const CaseFile& file);

}  // namespace zproof
