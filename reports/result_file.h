/// Files that zproof wrote, read again.
#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "reports/report_error.h"

namespace zproof {

/// All bytes of a regular file. Throws ReportError, with the file, what it is and what was expected, for any
/// other.
std::string read_result(const std::filesystem::path& file, const std::string& expected);

/// What is wrong with JSON that zproof should have written, in words, with the remedy.
std::string json_fault(const std::exception& of_the_parser);

}  // namespace zproof
