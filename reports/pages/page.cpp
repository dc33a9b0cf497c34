#include "reports/pages/writers.h"

#include <algorithm>

#include "reports/base64.h"
#include "reports/page_parts.h"
#include "reports/pages/cell_text.h"
#include "reports/wording.h"

namespace zproof::document {

namespace {

std::string svg_uri(const std::string& svg) { return "data:image/svg+xml;base64," + base64(svg); }

std::string uri_of(const Picture& picture) {
    return "data:image/png;base64," +
           base64({reinterpret_cast<const char*>(picture.png.data()), picture.png.size()});
}

std::string head_cell(const Table& table, std::size_t i) {
    const Column& column = table.columns[i];
    return "<th" + std::string{is_numeric(table, i) ? " class=\"n\"" : ""} +
           (column.meaning.empty() ? "" : " title=\"" + escaped(column.meaning) + "\"") + ">" +
           escaped(head_of(column)) + "</th>";
}

std::string body_cell(const Table& table, const Row& row, std::size_t i) {
    const std::string attributes = (is_numeric(table, i) ? " class=\"n\"" : "") +
                                   (is_number(row[i]) ? " data-value=\"" + exact_text(row[i]) + "\"" : "");
    return "<td" + attributes + ">" + escaped(readable_text(row[i])) + "</td>";
}

/// What the columns mean, for those who cannot hover.
std::string meanings(const Table& table) {
    std::string list;
    for (const Column& column : table.columns)
        if (!column.meaning.empty())
            list += "<dt>" + escaped(column.title) + "</dt><dd>" + escaped(column.meaning) + "</dd>\n";
    return list.empty() ? "" : "<details><summary>the columns</summary><dl>\n" + list + "</dl></details>\n";
}

std::string markup_of(const Table& table) {
    std::string heads, rows;
    for (std::size_t i = 0; i < table.columns.size(); ++i) heads += head_cell(table, i);
    for (std::size_t r = 0; r < std::min(table.shown, table.rows.size()); ++r) {
        rows += "<tr>";
        for (std::size_t i = 0; i < table.columns.size(); ++i) rows += body_cell(table, table.rows[r], i);
        rows += "</tr>\n";
    }
    const std::string remark = remark_on_rows(table);
    return "<h3>" + escaped(table.caption) +
           "</h3>\n<div class=\"wide\"><table class=\"sortable\"><thead><tr>" + heads +
           "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n" +
           (remark.empty() ? "" : "<p class=\"fine\">" + escaped(remark) + "</p>\n") + meanings(table);
}

std::string markup_of(const Plot& plot) {
    return "<div class=\"plot\">" + page_figure(svg_uri(chart_svg(plot.chart)), plot.caption) + "</div>\n";
}

std::string markup_of(const Picture& picture) {
    return "<div class=\"" + std::string{picture.group.empty() ? "picture" : "crop"} + "\">" +
           page_figure(uri_of(picture), picture.caption, picture.group) + "</div>\n";
}

std::string markup_of(const Drawing& drawing) {
    return "<div class=\"drawing\">" + page_figure(svg_uri(drawing.svg), drawing.caption) + "</div>\n";
}

/// What stands in one grid: neighbours of a kind, and pictures of one group.
std::string grid_of(const Item& item) {
    if (std::holds_alternative<Plot>(item)) return "plots";
    if (std::holds_alternative<Drawing>(item)) return "drawings";
    if (const auto* picture = std::get_if<Picture>(&item))
        return picture->group.empty() ? "pictures" : "crops " + picture->group;
    return "";
}

std::string markup_of(const std::vector<Item>& items) {
    std::string text, open;
    for (const Item& item : items) {
        const std::string grid = grid_of(item);
        if (grid != open) {
            text += open.empty() ? "" : "</div>\n";
            text += grid.empty() ? "" : "<div class=\"" + grid.substr(0, grid.find(' ')) + "\">\n";
            open = grid;
        }
        text += std::visit([](const auto& one) { return markup_of(one); }, item);
    }
    return text + (open.empty() ? "" : "</div>\n");
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string text;
    for (const std::string& one : texts) text += "<p class=\"reason\">" + escaped(one) + "</p>\n";
    return text;
}

}  // namespace

std::string_view page_style() {
    return R"css(
.plots, .drawings, .pictures {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 480px), 1fr)); gap: 1rem;
  margin: 1.2rem 0;
}
.plots img, .drawings img { background: #fff; }
.plot, .drawing, .picture { max-width: 960px; }
.crops {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(160px, 1fr)); gap: 0.9rem; margin: 1rem 0;
}
.crops img { image-rendering: pixelated; border-radius: 0; }
.sortable { font-size: 0.86rem; margin-bottom: 0.4rem; }
.sortable td, .sortable th { padding-right: 0.9rem; }
.wide + .fine, .wide + details { margin-bottom: 1.4rem; }
section h3 { margin-top: 1.6rem; }
details { margin: 0.4rem 0 1rem; font-size: 0.92rem; }
summary { cursor: pointer; color: var(--link); }
dt { font-weight: 600; }
)css";
}

std::string page_sections(const Document& document, const std::string& anchor) {
    std::string text;
    for (std::size_t i = 0; i < document.sections.size(); ++i) {
        const Section& section = document.sections[i];
        text += "<section id=\"" + anchor + std::to_string(i + 1) + "\">\n<h2>" + escaped(section.heading) +
                "</h2>\n" + paragraphs(section.paragraphs) + markup_of(section.items) + "</section>\n";
    }
    return text;
}

std::string page_of(const Document& document) {
    return page_head(document.title, page_style()) + "<body>\n<header>\n<h1>" + escaped(document.title) +
           "</h1>\n" + paragraphs(document.introduction) + "<p class=\"facts\">zproof " +
           escaped(document.version) + "</p>\n<p class=\"facts\"><code>" + escaped(document.command) +
           "</code></p>\n</header>\n<main>\n" + page_sections(document, "s") + "</main>\n" + page_end();
}

}  // namespace zproof::document
