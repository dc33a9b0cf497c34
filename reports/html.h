/// report.html, for people.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "reports/page_text.h"
#include "reports/pages/document.h"
#include "reports/results.h"

namespace zproof {

/// A page stays below this many bytes unless somebody asks for another limit.
inline constexpr std::size_t page_budget = 25'000'000;

/// Small pictures, which serve readers without scripts, take at most this part of a page as text. Failed
/// views are served first; a picture that no longer fits is replaced by a sentence that names its file.
constexpr std::size_t picture_budget(std::size_t budget) { return budget / 5 * 2; }

/// One self-contained page: summary first (failed views on top), then each view with its pictures
/// (run_folder/view.folder/*-small.png, left out where absent), class counts, depth error histograms and
/// worst pixels in words; all that without scripts. Where scripts run, the viewer opens on what is embedded
/// of run_folder/view.folder/planes.zvp, and tells what was left out to stay within the budget. The page's
/// content security policy admits that one script and forbids the network. A foreword stands before the views
/// and has the page's heading; studies stand at the end, and a table names them. Both are whole. Throws
/// ReportError where a planes.zvp is damaged. What the page holds of such files is read when it is written.
Page html_page(const Results& results, const std::filesystem::path& run_folder,
               std::size_t budget = page_budget, std::span<const document::Document> studies = {},
               const document::Document* foreword = nullptr);

/// The page's text, in memory.
std::string to_html(const Results& results, const std::filesystem::path& run_folder,
                    std::size_t budget = page_budget, std::span<const document::Document> studies = {},
                    const document::Document* foreword = nullptr);

}  // namespace zproof
