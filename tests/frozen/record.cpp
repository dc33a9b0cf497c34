#include "tests/frozen/record.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "math/sha256.h"

namespace zproof::frozen {

Record record_of(const Subject& subject, const VerdictText& text) {
    return {subject.group,           subject.name,          input_sha256(subject),
            sha256_of(text.classes), sha256_of(text.story), text.counts};
}

std::string line_of(const Record& r) {
    std::string line = r.group + " " + r.name + " " + r.input + " " + r.classes + " " + r.story;
    for (const auto& [name, count] : r.counts) line += " " + name + "=" + std::to_string(count);
    return line + "\n";
}

std::string difference(const CountsByClass& before, const CountsByClass& now) {
    std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> pairs;
    for (const auto& [name, count] : before) pairs[name].first = count;
    for (const auto& [name, count] : now) pairs[name].second = count;
    std::string text;
    for (const auto& [name, pair] : pairs)
        if (pair.first != pair.second)
            text += (text.empty() ? "" : ", ") + name + " " + std::to_string(pair.first) + " -> " +
                    std::to_string(pair.second);
    return text;
}

std::vector<Record> read_records(const std::filesystem::path& file) {
    std::vector<Record> records;
    std::ifstream in{file};
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("#")) continue;
        std::istringstream words{line};
        Record r;
        words >> r.group >> r.name >> r.input >> r.classes >> r.story;
        for (std::string word; words >> word;) {
            const std::size_t sign = word.find('=');
            r.counts[word.substr(0, sign)] = std::stoull(word.substr(sign + 1));
        }
        records.push_back(r);
    }
    if (records.empty()) throw std::runtime_error(file.string() + ": nothing is recorded there");
    return records;
}

}  // namespace zproof::frozen
