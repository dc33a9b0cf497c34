#include "reports/pages/writers.h"

#include <algorithm>

#include "reports/pages/cell_text.h"
#include "reports/wording.h"

namespace zproof::document {

namespace {

using Line = std::vector<std::string>;

/// Characters, not bytes: UTF-8 continuation bytes do not count.
std::size_t width_of(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<Line> lines_of(const Table& table) {
    std::vector<Line> lines(1);
    for (const Column& column : table.columns) lines.front().push_back(one_line(head_of(column)));
    for (std::size_t i = 0; i < std::min(table.shown, table.rows.size()); ++i) {
        lines.emplace_back();
        for (const Cell& cell : table.rows[i]) lines.back().push_back(one_line(readable_text(cell)));
    }
    return lines;
}

std::string set_in_columns(const Table& table) {
    const std::vector<Line> lines = lines_of(table);
    std::vector<std::size_t> widths(table.columns.size(), 0);
    for (const Line& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
    std::string text;
    for (const Line& line : lines) {
        std::string set;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string blanks(widths[i] - width_of(line[i]), ' ');
            set += (i == 0 ? "  " : "   ") + (is_numeric(table, i) ? blanks + line[i] : line[i] + blanks);
        }
        text += set.erase(set.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string text_of(const Table& table) {
    const std::string remark = remark_on_rows(table);
    return one_line(table.caption) + "\n" + set_in_columns(table) +
           (remark.empty() ? "" : "  (" + remark + ")\n");
}

}  // namespace

std::string terminal_text(const Document& document) {
    std::string text = one_line(document.title) + "\n";
    for (const std::string& paragraph : document.introduction) text += one_line(paragraph) + "\n";
    for (const Section& section : document.sections) {
        std::string tables;
        for (const Item& item : section.items)
            if (const auto* table = std::get_if<Table>(&item)) tables += "\n" + text_of(*table);
        if (!tables.empty()) text += "\n" + one_line(section.heading) + "\n" + tables;
    }
    return text;
}

}  // namespace zproof::document
