/// A run with one view of every outcome, and the frames of a small view.
#pragma once

#include <string>

#include "compare/verdict.h"
#include "frame/frame.h"
#include "frame/whole_file.h"
#include "reports/results.h"
#include "tests/support/test_folder.h"

namespace zproof {

inline constexpr const char* hostile_name = "</script><img onerror=x>";

/// A candidate, a reference and what a judge might say of them: 8 x 4, one hole at (6, 1), one edge at (2,
/// 3).
struct SampleView {
    Frame candidate, reference;
    Verdict verdict;
};
SampleView sample_view();

/// All that a view with defects leaves, the sample's, into the folder.
void write_sample_evidence(const std::filesystem::path& folder);

/// proven "meadow/dawn", defective "room/corner" with numbers that are hard to print, unreadable
/// hostile_name, not judged "empty/0", in this order.
Results sample_results();

/// How often part occurs in text.
std::size_t occurrences(const std::string& text, const std::string& part);

}  // namespace zproof
