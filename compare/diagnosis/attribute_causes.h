/// Why attributes are wrong: readings of what is told, each put to the judge (docs/diagnosis.md,
/// "Attributes").
#pragma once

#include <optional>

#include "compare/diagnosis/diagnosis_result.h"
#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Diagnoses the pixels of class wrong_attribute; nothing where there are none. The cause is that of the
/// attribute with the most wrong values, `further` are those of others, where one is certain.
std::optional<Diagnosis> diagnose_attributes(const DiagnosisInput& input, const Verdict& verdict);

}  // namespace zproof
