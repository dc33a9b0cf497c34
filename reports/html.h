/// report.html, for people.
#pragma once

#include <filesystem>
#include <string>

#include "reports/results.h"

namespace zproof {

/// Embedded pictures of a page take at most this many bytes as text, so that the page stays below 25 MB.
/// Failed views are served first; a picture that no longer fits is replaced by a sentence that names its
/// file.
inline constexpr std::size_t picture_budget = 22'000'000;

/// One self-contained page without scripts, which its own content security policy forbids along with the
/// network: summary first (failed views on top), then each view with its pictures
/// (run_folder/view.folder/*-small.png, left out where absent), class counts, depth error histograms and
/// worst pixels in words.
std::string to_html(const Results& results, const std::filesystem::path& run_folder);

}  // namespace zproof
