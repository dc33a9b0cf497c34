/// The file that waivers stand in (docs/gate.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/waivers/waiver.h"

namespace zproof {

/// Its waivers in their order. UsageError, "FILE:LINE:COLUMN: what was expected", for whatever is no waiver;
/// ReportError where the file cannot be read.
std::vector<Waiver> read_waivers(const std::filesystem::path& file);
std::vector<Waiver> parse_waivers(const std::string& text, const std::string& name);

/// One waiver as it stands in a file, from "[[waiver]]" to a newline.
std::string waiver_text(const Waiver& waiver);

/// The head of a file without waivers.
std::string empty_waiver_file();

/// The file's text without the waivers of these ids, each with its lines up to the next one; comments that
/// stand right above the next stay. Throws UsageError, which begins with `name`, where that would not leave
/// exactly the others: waivers that are no tables [[waiver]] of their own are a person's to remove.
std::string without_waivers(const std::string& text, const std::vector<std::string>& ids,
                            const std::string& name);

}  // namespace zproof
