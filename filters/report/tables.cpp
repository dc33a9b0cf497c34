#include "filters/report/tables.h"

#include <algorithm>

#include "filters/report/provenance.h"
#include "filters/report/table_cells.h"
#include "filters/study/claims.h"
#include "frame/joined.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

std::string latex_safe(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (std::string_view{"&%$#_{}"}.find(c) != std::string_view::npos) safe += '\\';
        if (c == '~')
            safe += "\\textasciitilde{}";
        else if (c == '^')
            safe += "\\textasciicircum{}";
        else if (c == '\\')
            safe += "\\textbackslash{}";
        else
            safe += c;
    }
    return safe;
}

std::string latex_row(const std::vector<std::string>& cells) {
    return joined(cells, " & ", [](const std::string& cell) { return latex_safe(one_line(cell)); }) +
           " \\\\\n";
}

/// The columns of one row but the metric and its value.
struct CsvPlace {
    const StudyResults& results;
    const ViewStudy& view;
    const MethodScore& method;

    std::string row(const std::string& region, std::uint64_t pixels,
                    const std::string& metric_and_value) const {
        return csv_field(view.scene) + "," + csv_field(view.view) + "," + std::to_string(view.width) + "," +
               std::to_string(view.height) + "," + csv_field(method.label) + "," + results.truth + "," +
               csv_field(region) + "," + std::to_string(pixels) + "," + metric_and_value + "\n";
    }
    std::string measured(const std::string& region, const std::string& metric, double value) const {
        return row(region, method.cost.pixels, metric + "," + shortest(value) + ",,");
    }
};

std::string region_rows(const CsvPlace& place, const RegionScore& score) {
    std::string text;
    if (score.pixels == 0) return text;
    const std::string certainty =
        "," + shortest(score.truth_half_width) + "," + (is_resolved(place.results, score) ? "yes" : "no");
    for (std::size_t i = 0; i < score.values.size(); ++i)
        text += place.row(score.region, score.pixels,
                          place.results.metrics[i].name + "," + shortest(score.values[i]) + certainty);
    return text;
}

std::string cost_rows(const CsvPlace& place) {
    const Cost& cost = place.method.cost;
    std::string text = place.measured("all", "texels", cost.texels) +
                       place.measured("all", "lines", cost.lines) +
                       place.measured("all", "bytes_stored", double(cost.bytes_stored)) +
                       place.measured("all", "build_ms", cost.build_ms) +
                       place.measured("all", "ns_per_sample", cost.ns_per_sample);
    if (place.method.flicker.steps == 0) return text;
    return text + place.measured("interior", "flicker", place.method.flicker.rms) +
           place.measured("interior", "flicker_ratio", place.method.flicker.ratio);
}

}  // namespace

std::string terminal_table(const TableCells& table) {
    std::vector<std::size_t> widths;
    for (const TableColumn& column : table.columns) widths.push_back(column.name.size());
    for (const auto& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    const auto line = [&](auto text_at) {
        std::string text;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const std::string word = text_at(i), gap(widths[i] - word.size(), ' ');
            text += (i == 0 ? "" : "  ") + (table.columns[i].is_text ? word + gap : gap + word);
        }
        return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
    };
    std::string text = table.title + "\n" + line([&](std::size_t i) { return table.columns[i].name; });
    for (const auto& row : table.rows) text += line([&](std::size_t i) { return one_line(row[i]); });
    return text;
}

std::string latex_table(const TableCells& table) {
    std::string shape;
    std::vector<std::string> names;
    for (const TableColumn& column : table.columns) {
        shape += column.is_text ? 'l' : 'r';
        names.push_back(column.name);
    }
    std::string text =
        "\\begin{table}\n\\caption{" + latex_safe(table.title) +
        "}\n\\centering\\footnotesize\n\\begin{tabular*}{\\textwidth}{@{\\extracolsep{\\fill}}" + shape +
        "@{}}\n\\toprule\n" + latex_row(names) + "\\midrule\n";
    for (const auto& row : table.rows) text += latex_row(row);
    return text + "\\bottomrule\n\\end{tabular*}\n\\end{table}\n";
}

std::string filters_csv(const StudyResults& results) {
    std::string text =
        provenance_comment(results) +
        "scene,view,width,height,method,truth,region,pixels,metric,value,truth_half_width,resolved\n";
    for (const ViewStudy& view : results.views)
        for (const MethodScore& method : view.methods) {
            const CsvPlace place{results, view, method};
            for (const RegionScore& score : method.regions) text += region_rows(place, score);
            text += cost_rows(place);
        }
    return text;
}

std::string filters_table(const StudyResults& results, const TableChoice& choice) {
    std::string text;
    for (const ViewStudy& view : results.views)
        text += (text.empty() ? "" : "\n") + terminal_table(table_cells(results, view, choice));
    return text;
}

std::string claim_words(const MethodScore& picture) {
    const ClaimCount& claim = picture.claim.value();
    return picture.label + " has " + counted(claim.pixels_outside, "pixel") + " outside what " +
           claim.method + " permits" + (claim.promise.empty() ? "" : ", promising " + claim.promise);
}

std::string claim_lines(const StudyResults& results) {
    std::string text;
    for (const ViewStudy& view : results.views)
        for (const MethodScore& method : view.methods)
            if (method.claim) text += view.scene + " / " + view.view + ": " + claim_words(method) + "\n";
    return text;
}

std::string filters_latex(const StudyResults& results, const TableChoice& choice) {
    std::string text = "% \\usepackage{booktabs}; " + truth_in_words(results.truth) + "\n";
    for (const ViewStudy& view : results.views) text += latex_table(table_cells(results, view, choice));
    return text;
}

}  // namespace zproof
