/// A study of texture filters as tables.
#pragma once

#include <string>

#include "filters/report/table_cells.h"

namespace zproof {

/// Provenance in comments; then long form, one value a row: scene, view, method, truth, region, pixels,
/// metric, value, truth_half_width, resolved. Costs and flicker stand in the region "all" or "interior" under
/// their own names. RFC 4180 with LF.
std::string filters_csv(const study::StudyResults& results);

/// Text for a terminal, a table per view: metrics in one region, flicker and costs. "not resolved" stands
/// where the truth is not known to a fifth of the method's distance from it; methods that cannot be told
/// apart share a rank.
std::string filters_table(const study::StudyResults& results, const TableChoice& choice);

/// "mine has 12 pixels outside what trilinear-gl permits, promising gpu"; of a picture with a claim.
std::string claim_words(const study::MethodScore& picture);

/// Such a line for each view and picture with a claim.
std::string claim_lines(const study::StudyResults& results);

/// The tables as LaTeX with booktabs, as wide as the text; a table environment per view.
std::string filters_latex(const study::StudyResults& results, const TableChoice& choice);

/// A table of cells in these forms.
std::string terminal_table(const TableCells& table);
std::string latex_table(const TableCells& table);

}  // namespace zproof
