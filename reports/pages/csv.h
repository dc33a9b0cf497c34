#pragma once

#include <string>

#include "reports/pages/document.h"

namespace zproof::document {

/// A line of heads, then every row (RFC 4180, with LF); numbers read back to the same bits.
std::string csv_of(const Table& table);

}  // namespace zproof::document
