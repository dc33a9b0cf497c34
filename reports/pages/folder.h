/// The folder of a study: what lies where.
#pragma once

#include <filesystem>

#include "reports/pages/document.h"
#include "reports/report_error.h"

namespace zproof::document {

/// Writes study.html, study.json, and a file for every item: NAME.csv for a table, NAME.svg for a chart or a
/// drawing, NAME.png for a picture. Throws FrameError where a file cannot be written, std::logic_error as
/// require_sound().
void write_document(const std::filesystem::path& folder, const Document& document);

/// Reads study.json and the pictures that it names. Throws ReportError where one is missing or damaged.
Document read_document(const std::filesystem::path& folder);

}  // namespace zproof::document
