/// The reports of a run as files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "reports/pages/document.h"
#include "reports/results.h"
#include "reports/text_sink.h"

namespace zproof {

enum class ReportFormat {
    html,    ///< report.html
    json,    ///< results.json; always written
    junit,   ///< junit.xml
    md,      ///< summary.md
    github,  ///< no file of its own: annotations on stdout, the summary of the step
    csv,     ///< results.csv
};

std::string name_of(ReportFormat format);
const std::vector<ReportFormat>& all_formats();
std::vector<ReportFormat> usual_formats();  ///< html, json, junit

/// The format of that name. Throws UsageError with the one that was probably meant.
ReportFormat format_from(const std::string& word);

/// Writes results.json and a file for each of the formats that has one, on the threads of the surrounding
/// tbb::task_arena. Throws ReportError or FrameError.
void write_reports(const std::filesystem::path& folder, const Results& results,
                   const std::vector<ReportFormat>& formats, const document::Document* foreword = nullptr);

/// Puts the report out; run_folder is where evidence is found, and what its links are relative to. Studies
/// and the foreword have a place in the page only.
void write_report(const TextSink& out, ReportFormat format, const Results& results,
                  const std::filesystem::path& run_folder, std::span<const document::Document> studies = {},
                  const document::Document* foreword = nullptr);

/// The results that a file, or the folder around it, holds. Throws ReportError naming it.
Results read_results(const std::filesystem::path& file_or_folder);
std::filesystem::path folder_of_results(const std::filesystem::path& file_or_folder);

}  // namespace zproof
