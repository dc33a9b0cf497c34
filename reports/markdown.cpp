#include "reports/formats.h"

#include <algorithm>
#include <vector>

#include "reports/diagnosis_words.h"
#include "reports/extent.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {

namespace {

constexpr std::size_t pixels_told = 3;
constexpr std::size_t room_for_remark = 200;

/// Text that Markdown shows as it is: HTML is escaped, and so is what Markdown reads.
std::string plain(const std::string& text) {
    std::string safe;
    for (const char c : one_line(text)) {
        if (std::string_view{"\\`*_{}[]#!|~"}.find(c) != std::string_view::npos) safe += '\\';
        safe += c;
    }
    return escaped(safe);
}

/// A command as it must be typed: in a block of its own, where only a fence could end it.
std::string code_block(const std::string& text) { return "\n        " + one_line(text) + "\n"; }

std::string word_of(Outcome outcome) {
    const std::string words(in_words(outcome));
    return std::string(glyph_of(outcome)) + " " + (outcome == Outcome::proven ? words : "**" + words + "**");
}

std::string markdown_headline(const Results& results) {
    const auto count = [&](Outcome outcome) {
        return std::uint64_t(std::ranges::count(results.views, outcome, &ViewResult::outcome));
    };
    std::uint64_t waived = 0;
    for (const ViewResult& v : results.views) waived += waived_count(v);
    std::string text = "## zproof: " + in_words(extent_of(results)) + ", " +
                       std::to_string(count(Outcome::proven)) + " proven";
    for (const Outcome outcome : all_outcomes)
        if (outcome != Outcome::proven && count(outcome) > 0)
            text += ", " + std::to_string(count(outcome)) + " " + std::string(in_words(outcome));
    if (waived > 0) text += "; " + counted(waived, "pixel") + " waived";
    if (results.ending != Ending::complete) text += "; " + std::string(name_of(results.ending));
    return text + "\n\n";
}

std::string row(const ViewResult& v) {
    std::string text = "| " + word_of(v.outcome) + " | " + plain(v.scene) + " | " + plain(v.view) + " | ";
    if (!was_judged(v)) return text + "| | | |\n";
    return text + grouped(std::uint64_t(v.width) * std::uint64_t(v.height)) + " | " +
           grouped(unwaived_defects(v)) + " | " + grouped(waived_count(v)) + " | " +
           error_over_bound_words(v) + " |\n";
}

std::string pixel(const ReportedFinding& told) {
    return "  - " + plain(told.explanation) + "\n" + code_block(told.command);
}

std::string view_story(const ViewResult& v) {
    std::string text =
        "- " + word_of(v.outcome) + " " + plain(v.scene) + (v.view.empty() ? "" : "/" + plain(v.view)) + ": ";
    std::string what = v.message.empty() ? "" : plain(v.message);
    for (std::size_t i = v.counts.size(); i-- > 0;)
        if (v.counts[i] > v.waived[i] && is_defect(PixelClass(i)))
            what += (what.empty() ? "" : ", ") + grouped(v.counts[i] - v.waived[i]) + " " +
                    plain(std::string(name_of(PixelClass(i))));
    text += what + "\n";
    if (v.diagnosis) text += "  - " + plain(in_words(*v.diagnosis)) + "\n";
    for (std::size_t i = 0; i < std::min(pixels_told, v.worst.size()); ++i)
        if (v.worst[i].waiver.empty() && is_defect(v.worst[i].finding.verdict)) text += pixel(v.worst[i]);
    return text;
}

std::string waiver_row(const WaiverStatus& s) {
    return "| " + plain(s.waiver->id) + " | " + plain(std::string(name_of(s.state))) + " | " +
           plain(s.waiver->scene) + " | " + grouped(s.waived) + " | " + in_words(s.waiver->expires) + " | " +
           plain(s.waiver->reason) + " | " + plain(s.waiver->link) + " |\n";
}

/// Lines of at most so many bytes together, and how many lines more there were.
class BoundedLines {
  public:
    explicit BoundedLines(std::size_t most_bytes) : room_(most_bytes - room_for_remark) {}

    void add(const std::string& line) {
        if (left_out_ > 0 || text_.size() + line.size() > room_)
            ++left_out_;
        else
            text_ += line;
    }

    std::string text() const {
        if (left_out_ == 0) return text_;
        return text_ + "\n" + counted(left_out_, "line") +
               " left out, for a summary has its limits; results.json has everything.\n";
    }

  private:
    std::size_t room_, left_out_ = 0;
    std::string text_;
};

void add_waivers(BoundedLines& lines, const Results& results) {
    const std::vector<WaiverStatus> statuses = waiver_statuses(results);
    if (statuses.empty()) return;
    lines.add(
        "\n### Waivers\n\n| waiver | state | scene | pixels let pass | until | reason | link |\n"
        "|---|---|---|---:|---|---|---|\n");
    for (const WaiverStatus& status : statuses) lines.add(waiver_row(status));
}

}  // namespace

std::string to_markdown(const Results& results) {
    const std::vector<const ViewResult*> views = failed_first(results);
    BoundedLines stories{largest_summary / 2};
    add_waivers(stories, results);
    stories.add("\n");
    for (const ViewResult* v : views)
        if (v->outcome != Outcome::proven) stories.add(view_story(*v));
    BoundedLines table{largest_summary - stories.text().size()};
    table.add(markdown_headline(results) +
              "| verdict | scene | view | pixels | defects | waived | error / bound |\n"
              "|---|---|---|---:|---:|---:|---:|\n");
    for (const ViewResult* v : views) table.add(row(*v));
    return table.text() + stories.text();
}

}  // namespace zproof
