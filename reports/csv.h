/// results.csv: the counts as a tidy table, for spreadsheets and statistics.
#pragma once

#include <string>

#include "reports/results.h"
#include "reports/text_sink.h"

namespace zproof {

/// A row per view and class, RFC 4180 with lines ended by a newline alone; a view that was not judged has one
/// row without class. Columns: scene, view, source, scene_sha256, candidate, reference, width, height,
/// triangles, outcome, class, gate (passes or fails), pixels, waived, message.
void write_csv(const TextSink& out, const Results& results);
std::string to_csv(const Results& results);  ///< the same, in memory

}  // namespace zproof
