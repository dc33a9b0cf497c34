/// Results of others, computed again: the figure as it was published, and ours.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zproof::study {

enum class PublishedAs {
    measurement,            ///< of inputs that we have as well
    measurement_elsewhere,  ///< of inputs that we have not: ours are of others
    identity,               ///< it follows from definitions
    expectation,            ///< it follows on the average over random numbers
};

struct PublishedFigure {
    std::string what, unit;
    double published = 0, ours = 0;
    int decimals = 2;
    PublishedAs as = PublishedAs::measurement;
    double standard_error = 0;  ///< of our estimate of an expectation
};

/// Is it so? Figures and identities agree to half a unit of the last decimal, estimates to three standard
/// errors. None where the inputs are others.
std::optional<bool> is_confirmed(const PublishedFigure& figure);

/// "reproduced", "not reproduced", "holds", "does not hold", "other inputs"
std::string verdict_on(const PublishedFigure& figure);

struct PublishedResult {
    std::string_view name;      ///< "hensley-2005"
    std::string_view sentence;  ///< what it says
    std::string_view source;
    std::vector<PublishedFigure> (*figures)();  ///< the same every time; on the surrounding tbb::task_arena
};

/// In the order of their years.
std::span<const PublishedResult> published_results();

}  // namespace zproof::study
