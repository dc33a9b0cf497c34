#include "reports/pages/writers.h"

#include "reports/pages/cell_text.h"
#include "reports/wording.h"

namespace zproof::document {

namespace {

template <class Values, class Text>
std::string line_of(const Values& values, Text text) {
    std::string line;
    for (const auto& value : values) line += (&value == &values.front() ? "" : ",") + csv_field(text(value));
    return line + "\n";
}

}  // namespace

std::string csv_of(const Table& table) {
    std::string csv = line_of(table.columns, head_of);
    for (const Row& row : table.rows) csv += line_of(row, exact_text);
    return csv;
}

}  // namespace zproof::document
