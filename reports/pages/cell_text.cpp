#include "reports/pages/cell_text.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof::document {

namespace {

std::string grouped_whole(std::int64_t value) {
    const auto magnitude = value < 0 ? 0 - std::uint64_t(value) : std::uint64_t(value);
    return (value < 0 ? "-" : "") + grouped(magnitude);
}

}  // namespace

std::string exact_text(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
    return shortest(std::get<double>(cell));
}

std::string readable_text(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return grouped_whole(*whole);
    return rounded(std::get<double>(cell));
}

bool is_number(const Cell& cell) { return !std::holds_alternative<std::string>(cell); }

std::string head_of(const Column& column) {
    return column.unit.empty() ? column.title : column.title + ", " + column.unit;
}

bool is_numeric(const Table& table, std::size_t column) {
    bool has_number = false;
    for (const Row& row : table.rows) {
        if (is_number(row[column]))
            has_number = true;
        else if (!std::get<std::string>(row[column]).empty())
            return false;
    }
    return has_number;
}

std::string remark_on_rows(const Table& table) {
    if (table.rows.size() <= table.shown) return "";
    return grouped(table.shown) + " of " + grouped(table.rows.size()) + " rows shown; all are in " +
           table.name + ".csv";
}

}  // namespace zproof::document
