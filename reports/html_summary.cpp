#include <array>

#include "reports/html_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

/// The class's name, broken at each underscore.
std::string broken_name(PixelClass c) {
    std::string name;
    for (const char letter : name_of(c)) name += letter == '_' ? std::string("<br>") : std::string(1, letter);
    return name;
}

bool is_quiet(const SummaryColumn& column, const std::string& text) {
    return column.zeros == Zeros::quiet && text.substr(0, text.find('\n')) == "0";
}

std::string number_cell(const SummaryColumn& column, const std::string& text) {
    std::string content;
    for (const char c : text) content += c == '\n' ? std::string("<br>") : std::string(1, c);
    return "<td class=\"" + column.kind + (is_quiet(column, text) ? " zero" : "") + "\">" + content + "</td>";
}

std::string measured_cells(const ViewResult& v, const std::vector<SummaryColumn>& columns) {
    if (!was_judged(v))
        return "<td colspan=\"" + std::to_string(columns.size()) + "\" class=\"message\">" +
               escaped(v.message) + "</td>";
    const std::vector<std::string> texts = summary_texts(v);
    std::string cells;
    for (std::size_t i = 0; i < columns.size(); ++i) cells += number_cell(columns[i], texts[i]);
    return cells;
}

std::string summary_row(const PageView& page, const std::vector<SummaryColumn>& columns) {
    const ViewResult& v = *page.view;
    return "<tr><td>" + outcome_badge(v.outcome) + "</td><td><a href=\"#" + page.anchor + "\">" +
           escaped(v.scene) + " <span class=\"view\">" + escaped(v.view) + "</span></a></td>" +
           measured_cells(v, columns) + "<td class=\"n\">" + fixed(seconds(v.times), 2) + "</td></tr>\n";
}

std::string heading(const SummaryColumn& column) {
    return "<th class=\"n\"" + (column.meaning.empty() ? "" : " title=\"" + column.meaning + "\"") + ">" +
           column.heading + "</th>";
}

}  // namespace

std::vector<SummaryColumn> summary_columns() {
    std::vector<SummaryColumn> columns{{.heading = "triangles"}, {.heading = "pixels"}};
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i)))
            columns.push_back({.heading = broken_name(PixelClass(i)), .zeros = Zeros::quiet});
    columns.push_back({.heading = "defects", .kind = "n defects", .zeros = Zeros::quiet});
    for (const std::string who : {"candidate", "reference"})
        columns.push_back(
            {.heading = "error / bound,<br>" + who, .meaning = "largest depth error / bound, " + who});
    return columns;
}

std::vector<std::string> summary_texts(const ViewResult& v) {
    std::vector<std::string> texts{grouped(v.triangles),
                                   grouped(std::uint64_t(v.width) * std::uint64_t(v.height))};
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i))) texts.push_back(grouped(v.counts[std::size_t(i)]));
    const std::string waived = waived_count(v) == 0 ? "" : "\n" + grouped(waived_count(v)) + " waived";
    texts.push_back(grouped(unwaived_defects(v)) + waived);
    texts.push_back(error_over_bound_words(v));
    texts.push_back(rounded(v.reference_depth.max_error_over_bound));
    return texts;
}

std::string html_summary(std::span<const PageView> pages) {
    if (pages.empty()) return "";
    const std::vector<SummaryColumn> columns = summary_columns();
    std::string headings, rows;
    for (const SummaryColumn& column : columns) headings += heading(column);
    for (const PageView& page : pages) rows += summary_row(page, columns);
    return "<details id=\"table\"><summary>Every view in numbers</summary>\n<div class=\"wide\"><table "
           "class=\"summary sortable\"><thead><tr><th>verdict</th><th>scene, "
           "view</th>" +
           headings + "<th class=\"n\">seconds</th></tr></thead><tbody>\n" + rows +
           "</tbody></table></div></details>\n";
}

}  // namespace zproof
