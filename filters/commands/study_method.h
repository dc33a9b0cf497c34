/// A filter as typed, made ready for a study.
#pragma once

#include "filters/commands/filter_choice.h"
#include "filters/study/plan.h"

namespace zproof {

/// Throws OracleError where a sampler of others is not on this machine.
study::StudyMethod study_method(const FilterChoice& choice);

}  // namespace zproof
