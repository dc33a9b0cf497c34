#include "cli/report_files.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>

#include "frame/joined.h"
#include "frame/whole_file.h"
#include "program/nearest_word.h"
#include "program/usage_error.h"
#include "reports/formats.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/result_file.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// The name of the format's file; empty where it has none.
std::string file_of(ReportFormat format) {
    switch (format) {
        case ReportFormat::html:
            return "report.html";
        case ReportFormat::json:
            return "results.json";
        case ReportFormat::junit:
            return "junit.xml";
        case ReportFormat::md:
            return "summary.md";
        case ReportFormat::csv:
            return "results.csv";
        case ReportFormat::github:
            return "";
    }
    return "";
}

void write_file(const fs::path& folder, const Results& results, ReportFormat format,
                const document::Document* foreword) {
    WholeFile file{folder / file_of(format)};
    write_report([&](std::string_view text) { file.append(text); }, format, results, folder, {}, foreword);
    file.finish();
}

fs::path file_of_results(const fs::path& file_or_folder) {
    std::error_code ignored;
    return fs::is_directory(file_or_folder, ignored) ? file_or_folder / "results.json" : file_or_folder;
}

}  // namespace

std::string name_of(ReportFormat format) {
    constexpr const char* names[] = {"html", "json", "junit", "md", "github", "csv"};
    return names[int(format)];
}

const std::vector<ReportFormat>& all_formats() {
    using enum ReportFormat;
    static const std::vector<ReportFormat> all{html, json, junit, md, github, csv};
    return all;
}

std::vector<ReportFormat> usual_formats() {
    return {ReportFormat::html, ReportFormat::json, ReportFormat::junit};
}

ReportFormat format_from(const std::string& word) {
    std::vector<std::string> names;
    for (const ReportFormat format : all_formats()) {
        names.push_back(name_of(format));
        if (word == names.back()) return format;
    }
    throw UsageError{"--report: '" + word + "' is no report" + did_you_mean(word, names) +
                     " (expected: " + joined(names) + ")"};
}

void write_reports(const fs::path& folder, const Results& results, const std::vector<ReportFormat>& formats,
                   const document::Document* foreword) {
    std::vector<ReportFormat> with_files{ReportFormat::json};
    for (const ReportFormat format : formats)
        if (!file_of(format).empty() && std::ranges::count(with_files, format) == 0)
            with_files.push_back(format);
    tbb::parallel_for_each(with_files,
                           [&](ReportFormat format) { write_file(folder, results, format, foreword); });
}

void write_report(const TextSink& out, ReportFormat format, const Results& results,
                  const fs::path& run_folder, std::span<const document::Document> studies,
                  const document::Document* foreword) {
    switch (format) {
        case ReportFormat::html:
            return write_page(out, html_page(results, run_folder, page_budget, studies, foreword));
        case ReportFormat::json:
            return write_json(out, results);
        case ReportFormat::junit:
            return write_junit(out, results);
        case ReportFormat::md:
            return out(to_markdown(results));
        case ReportFormat::github:
            return out(to_github(results));
        case ReportFormat::csv:
            return write_csv(out, results);
    }
}

Results read_results(const fs::path& file_or_folder) {
    const std::string text = read_result(file_of_results(file_or_folder), "the results.json of zproof run");
    try {
        return results_from_json(text);
    } catch (const ReportError& e) {
        throw ReportError{file_or_folder.string() + ": " + e.what()};
    }
}

fs::path folder_of_results(const fs::path& file_or_folder) {
    const fs::path folder = file_of_results(file_or_folder).parent_path();
    return folder.empty() ? "." : folder;
}

}  // namespace zproof
