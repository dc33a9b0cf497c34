#include "reports/terminal.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "reports/diagnosis_words.h"
#include "reports/extent.h"
#include "reports/notes.h"
#include "reports/renderer_record.h"
#include "reports/run_causes.h"
#include "reports/wording.h"

namespace zproof {

namespace {

enum class Align { left, right };

struct Column {
    enum class Need {
        always,      ///< what decides
        where_wide,  ///< on a screen that all columns fit on
    };
    std::string_view title;
    Align align;
    Need need = Need::where_wide;
};

const std::vector<Column> columns = [] {
    constexpr auto always = Column::Need::always;
    std::vector<Column> all{{"verdict", Align::left, always},
                            {"scene/view", Align::left, always},
                            {"triangles", Align::right},
                            {"pixels", Align::right}};
    for (int i = 0; i < pixel_class_count; ++i)
        if (has_column(PixelClass(i))) all.push_back({facts_of(PixelClass(i)).column, Align::right});
    all.push_back({"defects", Align::right, always});
    all.push_back({"err/bound", Align::right, always});
    all.push_back({"ref e/b", Align::right});
    all.push_back({"seconds", Align::right, always});
    return all;
}();
using TextRow = std::vector<std::string>;  ///< a text for each column
constexpr std::size_t longest_name = 36, gap = 2;

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

bool was_begun(const ViewResult& v) { return v.outcome != Outcome::not_judged || seconds(v.times) > 0; }

TextRow row_of(const ViewResult& v) {
    TextRow row{verdict_text(v.outcome), shortened(title_of(v))};
    const std::string time = was_begun(v) ? fixed(seconds(v.times), 2) : "";
    if (was_judged(v)) {
        row.push_back(grouped(v.triangles));
        row.push_back(grouped(std::uint64_t(v.width) * std::uint64_t(v.height)));
        for (int i = 0; i < pixel_class_count; ++i)
            if (has_column(PixelClass(i))) row.push_back(grouped(v.counts[std::size_t(i)]));
        row.push_back(defects_cell(v));
        row.push_back(error_over_bound_words(v));
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

std::size_t sum_of(const Widths& widths, const std::vector<std::size_t>& shown) {
    std::size_t sum = 0;
    for (const std::size_t i : shown) sum += widths[i] + (sum == 0 ? 0 : gap);
    return sum;
}

/// The places of the columns that are shown, from left to right.
std::vector<std::size_t> shown_columns(const Widths& widths, const std::optional<std::size_t>& screen) {
    std::vector<std::size_t> all, deciding;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        all.push_back(i);
        if (columns[i].need == Column::Need::always) deciding.push_back(i);
    }
    return !screen || sum_of(widths, all) <= *screen ? all : deciding;
}

std::string table(const Results& results, const SummaryStyle& style) {
    std::vector<const ViewResult*> views;
    std::vector<TextRow> rows;
    for (const ViewResult& v : results.views)
        if (was_begun(v)) views.push_back(&v), rows.push_back(row_of(v));
    if (rows.empty()) return "";
    const Widths widths = widths_of(rows);
    const std::vector<std::size_t> shown = shown_columns(widths, style.width);
    const auto line = [&](const auto& text_of) {
        std::string text;
        for (const std::size_t i : shown)
            text += (i == 0 ? "" : std::string(gap, ' ')) + padded(text_of(i), widths[i], columns[i].align);
        return text;
    };
    std::string text =
        faint(line([](std::size_t i) { return std::string(columns[i].title); }), style.colour) + "\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::string row = line([&](std::size_t i) { return rows[r][i]; });
        const std::size_t verdict = padded(rows[r][0], widths[0], Align::left).size();
        text += painted(row.substr(0, verdict), views[r]->outcome, style.colour) + row.substr(verdict) + "\n";
    }
    if (shown.size() < columns.size()) text += faint("--wide shows every column", style.colour) + "\n";
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

/// Views that nobody judged for one and the same reason.
using Alike = std::vector<const ViewResult*>;

/// Each view that is not proven, in reading order; those that are alike stand together.
std::vector<Alike> failures(const Results& results) {
    std::vector<Alike> all;
    std::map<std::pair<Outcome, std::string_view>, std::size_t> places;
    for (const ViewResult* v : failed_first(results)) {
        if (v->outcome == Outcome::proven) continue;
        const auto place = was_judged(*v) ? places.end() : places.find({v->outcome, v->message});
        if (place != places.end()) {
            all[place->second].push_back(v);
            continue;
        }
        places.insert({{v->outcome, v->message}, all.size()});
        all.push_back({v});
    }
    return all;
}

/// "room/door", or "74 views: room/door, room/floor, town/aerial, ...".
std::string titles_of(const Alike& group) {
    constexpr std::size_t most_named = 3;
    if (group.size() == 1) return title_of(*group.front());
    const auto whole_scenes =
        std::size_t(std::ranges::count_if(group, [](const ViewResult* v) { return stands_for_a_scene(*v); }));
    std::string text = in_words(Extent{.views = group.size() - whole_scenes, .whole_scenes = whole_scenes});
    for (std::size_t i = 0; i < std::min(group.size(), most_named); ++i)
        text += (i == 0 ? ": " : ", ") + title_of(*group[i]);
    return text + (group.size() > most_named ? ", ..." : "");
}

std::string story(const Alike& group, Colour colour) {
    const ViewResult& v = *group.front();
    std::string text = painted(verdict_text(v.outcome), v.outcome, colour) + "  " + titles_of(group);
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

/// Nothing where one view failed, whose story has said it.
std::string cause_line(const Results& results) {
    const bool is_told_above = failed_views(results) == 1 && results.diagnosis == CauseSearch::done;
    const std::string words = is_told_above ? "" : one_line(cause_in_words(results));
    return words.empty() ? "" : words + "\n";
}

}  // namespace

std::string summary_table(const Results& results, const SummaryStyle& style) {
    std::string text = style.rows == SummaryStyle::Rows::each_view ? table(results, style) : "";
    for (const Alike& group : failures(results)) text += "\n" + story(group, style.colour);
    return text + "\n" + note_lines(results) + oracle_lines(results) + cause_line(results) +
           outcomes(results, style.colour) + "\n" + totals(results) + "\n";
}

}  // namespace zproof
