#include "reports/terminal.h"

#include <algorithm>
#include <vector>

#include "reports/diagnosis_words.h"
#include "reports/extent.h"
#include "reports/notes.h"
#include "reports/renderer_record.h"
#include "reports/wording.h"

namespace zproof {

namespace {

enum class Align { left, right };

struct Column {
    std::string_view title;
    Align align;
};

const std::vector<Column> columns = [] {
    std::vector<Column> all{{"verdict", Align::left},
                            {"scene/view", Align::left},
                            {"triangles", Align::right},
                            {"pixels", Align::right}};
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i))) all.push_back({facts_of(PixelClass(i)).column, Align::right});
    for (const std::string_view title : {"defects", "err/bound", "ref e/b", "seconds"})
        all.push_back({title, Align::right});
    return all;
}();
using TextRow = std::vector<std::string>;  ///< a text for each column
constexpr std::size_t longest_name = 40;

std::string word_of(Outcome outcome) { return std::string(in_words(outcome)); }

std::string verdict_text(Outcome outcome) { return std::string(glyph_of(outcome)) + " " + word_of(outcome); }

/// SGR codes: bold red, bold yellow, green.
std::string painted(const std::string& text, Outcome outcome, Colour colour) {
    if (colour == Colour::plain) return text;
    const char* const code = outcome == Outcome::proven      ? "32"
                             : outcome == Outcome::defective ? "1;31"
                                                             : "1;33";
    return std::string("\x1b[") + code + "m" + text + "\x1b[0m";
}

std::string faint(const std::string& text, Colour colour) {
    return colour == Colour::plain ? text : "\x1b[2m" + text + "\x1b[0m";
}

bool starts_character(char c) { return (std::uint8_t(c) & 0xC0) != 0x80; }

/// Columns on screen, as far as one code point takes one.
std::size_t width_of(std::string_view text) {
    return std::size_t(std::ranges::count_if(text, starts_character));
}

std::string padded(const std::string& text, std::size_t width, Align align) {
    const std::string blanks(width - std::min(width, width_of(text)), ' ');
    return align == Align::left ? text + blanks : blanks + text;
}

/// A long name keeps both ends: file names differ at the end, folders at the start.
std::string shortened(const std::string& name) {
    if (width_of(name) <= longest_name) return name;
    const auto place = [&](std::size_t character) {
        std::size_t i = 0;
        for (std::size_t seen = 0; i < name.size(); ++i)
            if (starts_character(name[i]) && seen++ == character) break;
        return i;
    };
    const std::size_t keep = longest_name / 2;
    return name.substr(0, place(keep - 1)) + "…" + name.substr(place(width_of(name) - keep));
}

std::string title_of(const ViewResult& v) {
    return one_line(v.scene) + (stands_for_a_scene(v) ? "" : "/" + one_line(v.view));
}

/// "3 (2 waived)": the defects that fail the gate, and those that waivers let pass.
std::string defects_cell(const ViewResult& v) {
    const std::string failing = grouped(unwaived_defects(v));
    return waived_count(v) == 0 ? failing : failing + " (" + grouped(waived_count(v)) + " waived)";
}

TextRow row_of(const ViewResult& v) {
    TextRow row{verdict_text(v.outcome), shortened(title_of(v))};
    const bool was_begun = v.outcome != Outcome::not_judged || seconds(v.times) > 0;
    const std::string time = was_begun ? fixed(seconds(v.times), 2) : "";
    if (was_judged(v)) {
        row.push_back(grouped(v.triangles));
        row.push_back(grouped(std::uint64_t(v.width) * std::uint64_t(v.height)));
        for (int i = 0; i < pixel_class_count; ++i)
            if (has_column(PixelClass(i))) row.push_back(grouped(v.counts[std::size_t(i)]));
        row.push_back(defects_cell(v));
        row.push_back(rounded(v.candidate_depth.max_error_over_bound));
        row.push_back(rounded(v.reference_depth.max_error_over_bound));
    }
    row.resize(columns.size() - 1);
    row.push_back(time);
    return row;
}

using Widths = std::vector<std::size_t>;

Widths widths_of(const std::vector<TextRow>& rows) {
    Widths widths(columns.size());
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = width_of(columns[i].title);
    for (const TextRow& row : rows)
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    return widths;
}

std::string heading(const Widths& widths) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i)
        line += (i == 0 ? "" : "  ") + padded(std::string(columns[i].title), widths[i], columns[i].align);
    return line;
}

std::string table(const Results& results, Colour colour) {
    std::vector<TextRow> rows;
    for (const ViewResult& v : results.views) rows.push_back(row_of(v));
    const Widths widths = widths_of(rows);
    std::string text = faint(heading(widths), colour) + "\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        text += painted(padded(rows[r][0], widths[0], Align::left), results.views[r].outcome, colour);
        for (std::size_t i = 1; i < widths.size(); ++i)
            text += "  " + padded(rows[r][i], widths[i], columns[i].align);
        text += "\n";
    }
    return text;
}

std::string tally(const ViewResult& v) {
    std::string text;
    for (std::size_t i = v.counts.size(); i-- > 0;) {
        if (v.counts[i] == 0 || passes(PixelClass(i))) continue;
        text += (text.empty() ? "" : ", ") + grouped(v.counts[i]) + " " + std::string(name_of(PixelClass(i)));
        if (v.waived[i] > 0) text += " (" + grouped(v.waived[i]) + " waived)";
    }
    return text;
}

std::string story(const ViewResult& v, Colour colour) {
    std::string text = painted(verdict_text(v.outcome), v.outcome, colour) + "  " + title_of(v);
    if (!v.reference.empty()) text += "  against " + one_line(v.reference);
    text += "\n";
    if (!tally(v).empty()) text += "    " + tally(v) + "\n";
    if (v.diagnosis) text += "    " + one_line(in_words(*v.diagnosis)) + "\n";
    if (!v.message.empty()) text += "    " + one_line(v.message) + "\n";
    if (v.worst.empty()) return text;
    const ReportedFinding& first = v.worst.front();
    return text + "    " + one_line(first.explanation) + "\n    " + faint(one_line(first.command), colour) +
           "\n";
}

std::string totals(const Results& results) {
    std::uint64_t pixels = 0, defects = 0, waived = 0, reference_defects = 0;
    double time = 0;
    for (const ViewResult& v : results.views) {
        if (was_judged(v)) pixels += std::uint64_t(v.width) * std::uint64_t(v.height);
        defects += unwaived_defects(v);
        waived += waived_count(v);
        reference_defects += v.reference_defects;
        time += seconds(v.times);
    }
    return grouped(pixels) + " pixels judged: " + counted(defects, "defect") + ", " +
           (waived == 0 ? "" : grouped(waived) + " waived, ") +
           counted(reference_defects, "reference defect") + "   " + fixed(time, 1) + " s";
}

/// The pixels that an oracle was asked about, where they are samples.
std::string asked_pixels(const RendererRecord& r) {
    return r.pixels == r.of_pixels ? "" : sample_words(r.pixels, r.of_pixels, r.seed) + ", ";
}

/// A line for each oracle; candidate and reference have theirs in the table.
std::string oracle_lines(const Results& results) {
    std::string text;
    for (const RendererRecord& r : renderer_records(results)) {
        if (r.role != "oracle") continue;
        text += one_line(r.name) + ": ";
        if (r.views > 0)
            text += counted(r.views, "view") + ", " + asked_pixels(r) + counted(r.defects, "defect") +
                    ", err/bound " + rounded(r.depth_error_over_bound) + (r.not_compared > 0 ? "; " : "");
        if (r.not_compared > 0)
            text += "not compared in " + counted(r.not_compared, "view") + ": " + one_line(r.absent);
        text += "\n";
    }
    return text;
}

std::string outcomes(const Results& results, Colour colour) {
    std::string text = in_words(extent_of(results)) + ":";
    for (const Outcome outcome : all_outcomes) {
        const auto count = std::ranges::count(results.views, outcome, &ViewResult::outcome);
        if (count == 0) continue;
        const std::string part =
            std::string(glyph_of(outcome)) + " " + std::to_string(count) + " " + word_of(outcome);
        text += "  " + painted(part, outcome, colour);
    }
    return text;
}

}  // namespace

std::string summary_table(const Results& results, Colour colour) {
    std::string text = results.views.empty() ? "" : table(results, colour);
    for (const ViewResult* v : failed_first(results))
        if (v->outcome != Outcome::proven) text += "\n" + story(*v, colour);
    return text + "\n" + note_lines(results) + oracle_lines(results) + outcomes(results, colour) + "\n" +
           totals(results) + "\n";
}

}  // namespace zproof
