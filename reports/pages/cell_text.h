/// A table's numbers and heads as text.
#pragma once

#include <string>
#include <vector>

#include "reports/pages/document.h"

namespace zproof::document {

std::string exact_text(const Cell& cell);     ///< reads back to the same value: for programs
std::string readable_text(const Cell& cell);  ///< three significant digits, whole numbers grouped: for people
bool is_number(const Cell& cell);

std::string head_of(const Column& column);  ///< "error, px"

/// Does the column hold numbers only, but for empty words? Such a column is set flush right.
bool is_numeric(const Table& table, std::size_t column);

/// "12 of 4,096 rows shown; all are in NAME.csv"; empty where all are.
std::string remark_on_rows(const Table& table);

}  // namespace zproof::document
