#include "tests/frozen/record.h"

#include <fstream>
#include <stdexcept>

#include "math/sha256.h"

namespace zproof::frozen {

Record record_of(const Subject& subject, const VerdictText& text) {
    return {subject.group, subject.name, input_sha256(subject), sha256_of(text.classes),
            sha256_of(text.story)};
}

std::string line_of(const Record& r) {
    return r.group + " " + r.name + " " + r.input + " " + r.classes + " " + r.story + "\n";
}

std::vector<Record> read_records(const std::filesystem::path& file) {
    std::vector<Record> records;
    std::ifstream in{file};
    for (Record r; in >> r.group >> r.name >> r.input >> r.classes >> r.story;) records.push_back(r);
    if (records.empty()) throw std::runtime_error(file.string() + ": nothing is recorded there");
    return records;
}

}  // namespace zproof::frozen
