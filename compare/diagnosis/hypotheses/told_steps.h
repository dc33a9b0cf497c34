/// Depths that were rounded or cut to whole steps on their way into a file, whatever else was done to them.
#pragma once

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// The step of which all that the candidate tells for depth are whole multiples: of units, of their parts, or
/// of 8 or 16 bits up to 1 or to far. 0 where there is none, or too few levels to tell.
double told_step(const DiagnosisInput& input);

/// What the hypothesis reports may have been rounded or cut to such steps.
void allow_steps(Hypothesis& hypothesis, double step);

}  // namespace zproof
