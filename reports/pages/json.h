/// A document as JSON and back. Pictures and drawings are files of their own, which the JSON names.
#pragma once

#include <functional>
#include <string>

#include "reports/pages/document.h"
#include "reports/report_error.h"

namespace zproof::document {

std::string json_of(const Document& document);

/// The bytes of a file that the JSON names.
using ReadFile = std::function<std::string(const std::string& file)>;

/// Throws ReportError, which names the place, where the text is no document of schema 1.x.
Document document_from_json(const std::string& text, const ReadFile& read_file);

}  // namespace zproof::document
