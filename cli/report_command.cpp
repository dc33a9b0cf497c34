#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>

#include "cli/commands.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "program/common_arguments.h"
#include "program/usage_error.h"
#include "reports/pages/folder.h"
#include "reports/report_error.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

ReportFormat format_of(const ReportAgainArguments& arguments) {
    if (arguments.format) return *arguments.format;
    using enum ReportFormat;
    static const std::map<std::string, ReportFormat> endings{{".html", html}, {".htm", html}, {".json", json},
                                                             {".xml", junit}, {".md", md},    {".csv", csv}};
    const auto found = endings.find(arguments.common.out.extension().string());
    if (found != endings.end()) return found->second;
    throw UsageError{"-o " + arguments.common.out.string() +
                     ": expected a name ending in .html, .json, .xml, .md or .csv; or say which report with "
                     "--format"};
}

/// The evidence as seen from the folder of the new report.
void point_to_evidence(Results& results, const fs::path& run_folder, const fs::path& report_folder) {
    for (ViewResult& view : results.views)
        if (!view.folder.empty())
            view.folder = fs::proximate(run_folder / view.folder, report_folder).generic_string();
}

bool is_study(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / "study.json", ignored);
}

/// Studies have a place in the page only.
std::vector<document::Document> studies_of(const ReportAgainArguments& arguments, ReportFormat format) {
    std::vector<document::Document> studies;
    for (const fs::path& one : arguments.results) {
        if (!is_study(one)) continue;
        if (format != ReportFormat::html)
            throw UsageError{one.string() + ": is a study, which only an .html report can show"};
        studies.push_back(document::read_document(one));
    }
    return studies;
}

/// Where more than one run is told of, each view has the command of its own.
void hand_command_to_views(Results& run) {
    for (ViewResult& view : run.views)
        if (view.command.empty()) view.command = run.command;
    run.command.clear();
    run.argv.clear();
}

/// The views of all, one after the other; everything else is the first one's.
Results all_of(const ReportAgainArguments& arguments, const fs::path& report_folder) {
    std::vector<Results> read;
    for (const fs::path& one : arguments.results) {
        if (is_study(one)) continue;
        read.push_back(read_results(one));
        point_to_evidence(read.back(), folder_of_results(one), report_folder);
        if (read.back().version != read.front().version)
            throw ReportError{one.string() + ": was written by zproof " + read.back().version +
                              ", the first by " + read.front().version + "; report on each by itself"};
    }
    if (read.empty())
        throw UsageError{
            "report: expected the results of a run beside the studies, which have pages of their own"};
    if (read.size() > 1) std::ranges::for_each(read, hand_command_to_views);
    Results results = std::move(read.front());
    for (std::size_t i = 1; i < read.size(); ++i)
        std::ranges::move(read[i].views, std::back_inserter(results.views));
    return results;
}

}  // namespace

ExitCode execute(const ReportAgainArguments& arguments) {
    const bool to_stdout = arguments.common.out == "-";
    if (to_stdout && !arguments.format)
        throw UsageError{"-o -: expected --format beside it: html, json, junit, md, github or csv"};
    const ReportFormat format = format_of(arguments);
    const fs::path folder =
        to_stdout || !arguments.common.out.has_parent_path() ? "." : arguments.common.out.parent_path();
    const std::vector<document::Document> studies = studies_of(arguments, format);
    const Results results = all_of(arguments, folder);
    const auto write = [&](const TextSink& out) {
        on_threads(arguments.common.threads, [&] { write_report(out, format, results, folder, studies); });
    };
    if (to_stdout) {
        write([](std::string_view text) { std::cout << text; });
        return ExitCode::proven;
    }
    WholeFile file{arguments.common.out};
    write([&](std::string_view text) { file.append(text); });
    file.finish();
    std::cout << one_line(arguments.common.out.string()) << "\n";
    return ExitCode::proven;
}

}  // namespace zproof
