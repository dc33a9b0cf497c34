/// A document as a page, as CSV and on the terminal.
#pragma once

#include <string>

#include "reports/pages/document.h"

namespace zproof::document {

/// One page that holds all it shows and needs no network; without scripts, all but sorting and zooming is
/// there. Cells of numbers have their exact value as data-value.
std::string page_of(const Document& document);

/// The sections alone, for a page that has room for several documents; `anchor` begins the ids of its parts.
std::string page_sections(const Document& document, const std::string& anchor);

/// What these sections need beside html_style().
std::string_view page_style();

/// A line of heads, then every row (RFC 4180, with LF); numbers read back to the same bits.
std::string csv_of(const Table& table);

/// The text for the terminal: headings, the introduction, and each table's first rows in columns. Paragraphs,
/// charts and pictures are left to the page.
std::string terminal_text(const Document& document);

}  // namespace zproof::document
