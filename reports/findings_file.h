/// findings.csv, read back (reports/evidence.h writes it).
#pragma once

#include <string>
#include <vector>

#include "compare/verdict.h"

namespace zproof {

/// The findings with place, class and both ids; depths and bounds are left at their defaults. Throws
/// ReportError, "NAME:LINE: ...", for a line that is none.
std::vector<Finding> findings_from_csv(const std::string& text, const std::string& name);

}  // namespace zproof
