/// A study of texture filters as tables.
#pragma once

#include <string>

#include "study/filters/results.h"

namespace zproof {

/// Long form, one value a row: scene, view, method, truth, region, pixels, metric, value, truth_half_width,
/// resolved. Costs and flicker stand in the region "all" or "interior" under their own names. RFC 4180 with
/// LF.
std::string filters_csv(const study::StudyResults& results);

/// Text for a terminal, a table per view: metrics in one region, flicker and costs. "not resolved" stands
/// where the truth is not known to a fifth of the method's distance from it; methods that cannot be told
/// apart share a rank.
std::string filters_table(const study::StudyResults& results, const std::string& region);

/// The tables as LaTeX with booktabs; a table environment per view.
std::string filters_latex(const study::StudyResults& results, const std::string& region);

}  // namespace zproof
