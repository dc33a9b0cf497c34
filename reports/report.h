/// Reports of a run. Every report is a pure function of Results and the frames beside it.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <stdexcept>
#include <string>

#include "compare/verdict.h"
#include "frame/frame.h"
#include "reports/results.h"

namespace zproof {

/// A report could not be written: names the path and the reason.
struct ReportError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string to_json(const Results& results);  ///< results.json, schema reports/results.schema.json
Results results_from_json(const std::string& text);  ///< inverse of to_json; throws ReportError
std::string to_junit(const Results& results);  ///< junit.xml, Jenkins dialect: a suite per reference, a case per view

/// Writes one view's evidence into folder: candidate.exr, reference.exr, id.png, reference-id.png, depth.png,
/// class.png, findings.csv.
void write_view_evidence(const std::filesystem::path& folder, const Frame& candidate, const Frame& reference,
                         const Verdict& verdict);

/// report.html, self-contained: summary table first (failed first), then each view with its pictures (read from
/// run_folder/view.folder), counts, error/bound histogram, worst pixels in words. No scripts, no network.
std::string to_html(const Results& results, const std::filesystem::path& run_folder);

/// An output folder that appears whole or not at all: written as PATH.tmp-PID, renamed by publish().
/// Replaces PATH only where PATH is a folder that zproof itself made (it holds .zproof-out); otherwise the
/// constructor throws ReportError. The destructor removes what was not published.
class OutputFolder {
  public:
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& working() const { return working_; }  ///< where to write
    void publish();

  private:
    std::filesystem::path path_, working_;
    bool published_ = false;
};

}  // namespace zproof
