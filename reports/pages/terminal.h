#pragma once

#include <string>

#include "reports/pages/document.h"

namespace zproof::document {

/// The text for the terminal: headings, the introduction, and each table's first rows in columns. Paragraphs,
/// charts and pictures are left to the page.
std::string terminal_text(const Document& document);

}  // namespace zproof::document
