/// Results of others, computed again: the figure as it was published, and ours.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::study {

struct PublishedFigure {
    std::string what, unit;
    double published = 0, ours = 0;
    int decimals = 2;
};

struct PublishedResult {
    std::string_view name;      ///< "hensley-2005"
    std::string_view sentence;  ///< what it says
    std::string_view source;
    std::vector<PublishedFigure> (*figures)();  ///< the same every time; on the surrounding tbb::task_arena
};

/// In the order of their years.
std::span<const PublishedResult> published_results();

}  // namespace zproof::study
