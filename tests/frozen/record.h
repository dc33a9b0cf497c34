/// A line of frozen.txt.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/frozen/verdict_text.h"

namespace zproof::frozen {

/// "GROUP NAME INPUT CLASSES STORY agree=480 edge=2": what was judged and what came of it, each by its
/// SHA-256, and how many pixels have which class.
struct Record {
    std::string group, name;
    std::string input;     ///< input_sha256()
    std::string classes;   ///< of VerdictText::classes
    std::string story;     ///< of VerdictText::story
    CountsByClass counts;  ///< empty where only another processor gives these classes
};

Record record_of(const Subject& subject, const VerdictText& text);
std::string line_of(const Record& record);

/// What a change did, "edge 30 -> 28, hole 0 -> 2"; empty where all counts are the same.
std::string difference(const CountsByClass& before, const CountsByClass& now);

/// Every line of the file. Throws std::runtime_error where there is none.
std::vector<Record> read_records(const std::filesystem::path& file);

}  // namespace zproof::frozen
