/// A line of frozen.txt.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/frozen/verdict_text.h"

namespace zproof::frozen {

/// "GROUP NAME INPUT CLASSES STORY": what was judged and what came of it, each by its SHA-256.
struct Record {
    std::string group, name;
    std::string input;    ///< input_sha256()
    std::string classes;  ///< of VerdictText::classes
    std::string story;    ///< of VerdictText::story
};

Record record_of(const Subject& subject, const VerdictText& text);
std::string line_of(const Record& record);

/// Every line of the file. Throws std::runtime_error where there is none.
std::vector<Record> read_records(const std::filesystem::path& file);

}  // namespace zproof::frozen
