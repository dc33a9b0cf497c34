#include "reports/document/csv.h"

#include "reports/document/cell_text.h"

namespace zproof::document {

namespace {

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
    return quoted + "\"";
}

template <class Values, class Text>
std::string line_of(const Values& values, Text text) {
    std::string line;
    for (const auto& value : values) line += (&value == &values.front() ? "" : ",") + field(text(value));
    return line + "\n";
}

}  // namespace

std::string csv_of(const Table& table) {
    std::string csv = line_of(table.columns, head_of);
    for (const Row& row : table.rows) csv += line_of(row, exact_text);
    return csv;
}

}  // namespace zproof::document
