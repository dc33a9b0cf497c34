#include "cli/announcement.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>

#include "cli/outcome_code.h"
#include "reports/extent.h"
#include "reports/formats.h"
#include "reports/report_error.h"
#include "reports/terminal.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {

namespace {

bool is_asked_for(const ReportArguments& report, ReportFormat format) {
    return std::ranges::count(report.formats, format) > 0;
}

/// Steps append to the file: what others wrote stays.
void summarize_step(const Results& results) {
    const char* file = std::getenv("GITHUB_STEP_SUMMARY");
    if (file == nullptr || *file == '\0') return;
    std::ofstream out{file, std::ios::binary | std::ios::app};
    out << to_markdown(results) << std::flush;
    if (!out) throw ReportError{std::string{file} + ": the step's summary cannot be written"};
}

/// -q leaves errors.
void remark_on_waivers(const Results& results, const CommonArguments& common) {
    for (const WaiverStatus& status : waiver_statuses(results)) {
        const bool is_error = fails(status, results.strictness);
        if (const std::string advice = advice_for(status);
            !advice.empty() && (is_error || !common.is_quiet()))
            std::cerr << "zproof: " << (is_error ? "error: " : "warning: ") << one_line(advice) << "\n";
    }
}

/// "16 views"; where some were not judged, "8 views; 6 views and 1 whole scene not judged".
std::string judged_views(const Results& results) {
    const auto was_left = [](const ViewResult& view) { return view.outcome == Outcome::not_judged; };
    const auto was_tried = [&](const ViewResult& view) { return !was_left(view); };
    const Extent left = extent_of(results, was_left);
    const std::string tried = in_words(extent_of(results, was_tried));
    return left.views + left.whole_scenes == 0 ? tried : tried + "; " + in_words(left) + " not judged";
}

/// What was judged, where that is less than triangles: ", ids: material".
std::string what_was_judged(const Results& results) {
    if (results.renderers.empty()) return "";
    const RendererFacts& candidate = results.renderers.front();
    return candidate.ids == "triangle" ? "" : ", " + ids_in_words(candidate);
}

/// The page if one was written, else results.json.
std::string where_to_look(const ReportArguments& report) {
    const bool page = is_asked_for(report, ReportFormat::html);
    return (report.common.out / (page ? "report.html" : "results.json")).string();
}

/// "; next: zproof explain ...": the worst pixel of the first view that failed.
std::string what_next(const Results& results) {
    for (const ViewResult* view : failed_first(results))
        if (view->outcome != Outcome::proven && !view->worst.empty())
            return "; next: " + view->worst.front().command;
    return "";
}

/// The screen's, where there is one; else that of most.
std::size_t screen_width() {
    winsize size{};
    const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return is_known ? size.ws_col : 80;
}

SummaryStyle summary_style(const ReportArguments& report, SummaryStyle::Rows rows) {
    SummaryStyle style{.colour = wants_colours(report.common) ? Colour::ansi : Colour::plain};
    if (report.columns == ReportArguments::Columns::all) return style;
    style.width = screen_width();
    style.rows = rows;
    return style;
}

}  // namespace

ExitCode announce(const Results& results, const ReportArguments& report, SummaryStyle::Rows rows,
                  ExitCode beside) {
    const ExitCode code = worst_of({exit_code_of(results), beside});
    const CommonArguments& common = report.common;
    if (!common.is_quiet()) std::cout << summary_table(results, summary_style(report, rows));
    if (common.detail == Detail::times) std::cout << times_table(results);
    if (is_asked_for(report, ReportFormat::github)) {
        std::cout << to_github(results);
        summarize_step(results);
    }
    remark_on_waivers(results, common);
    std::cout << in_words(code) << ": " << judged_views(results) << one_line(what_was_judged(results))
              << "; report: " << one_line(where_to_look(report) + what_next(results)) << "\n";
    return code;
}

namespace {

using Stage = std::pair<const char*, double StageTimes::*>;
constexpr std::array stages{Stage{"load", &StageTimes::load},
                            Stage{"render", &StageTimes::render},
                            Stage{"reference build", &StageTimes::reference_build},
                            Stage{"reference", &StageTimes::reference},
                            Stage{"judge", &StageTimes::judge},
                            Stage{"oracles", &StageTimes::oracles},
                            Stage{"write", &StageTimes::write}};

std::string padded_left(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string row(std::string name, double part, double whole) {
    name.resize(16, ' ');
    const double percent = whole > 0 ? 100 * part / whole : 0;
    return name + padded_left(fixed(part, 3), 10) + " s" + padded_left(fixed(percent, 1), 7) + " %\n";
}

}  // namespace

std::string times_table(const Results& results) {
    double whole = 0;
    for (const ViewResult& view : results.views) whole += seconds(view.times);
    std::string table;
    for (const auto& [name, member] : stages) {
        double part = 0;
        for (const ViewResult& view : results.views) part += view.times.*member;
        table += row(name, part, whole);
    }
    return table + row("together", whole, whole);
}

}  // namespace zproof
