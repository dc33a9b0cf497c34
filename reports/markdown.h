/// summary.md: the run on one page of GitHub's Markdown, for the summary of a CI step and for pull requests.
#pragma once

#include <cstddef>
#include <string>

#include "reports/results.h"

namespace zproof {

/// GitHub takes a step's summary of up to 1 MiB and drops a larger one whole; the rest is for other steps.
inline constexpr std::size_t largest_summary = 1'000'000;

/// Verdict in a sentence, a table of the views (failed first), the story of those that fail, and what the
/// waivers did. Text only: names are escaped, so that a scene can neither write markup nor break the table.
/// Never larger than largest_summary bytes, of which the table takes what stories and waivers leave, at least
/// half; what was left out is said.
std::string to_markdown(const Results& results);

}  // namespace zproof
