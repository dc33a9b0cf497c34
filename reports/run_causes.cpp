#include "reports/run_causes.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof {

std::vector<RunCause> run_causes(const Results& results) {
    std::vector<RunCause> causes;
    for (const ViewResult& view : results.views) {
        if (view.outcome != Outcome::defective || !view.diagnosis || !view.diagnosis->cause) continue;
        const Explanation& cause = *view.diagnosis->cause;
        auto known = std::ranges::find(causes, cause.name, &RunCause::name);
        if (known == causes.end()) known = causes.insert(known, {cause.name, cause.look_at, cause.fitted});
        if (known->fitted != cause.fitted) known->fitted.clear();
        ++known->views;
    }
    std::ranges::stable_sort(causes, std::greater{}, &RunCause::views);
    return causes;
}

std::uint64_t failed_views(const Results& results) {
    return std::uint64_t(std::ranges::count(results.views, Outcome::defective, &ViewResult::outcome));
}

std::string in_words(const std::vector<RunCause>& causes, std::uint64_t failed_views) {
    if (failed_views == 0) return "";
    if (causes.empty()) return "No cause is certain.";
    const RunCause& first = causes.front();
    const std::string of =
        first.views == failed_views
            ? (failed_views == 1 ? "Likely cause"
                                 : "Likely cause of all " + counted(failed_views, "failed view"))
            : "Likely cause of " + grouped(first.views) + " of " + counted(failed_views, "failed view");
    return of + ": " + first.name + (first.fitted.empty() ? "." : ": " + first.fitted + ".") +
           (first.look_at.empty() ? "" : " " + first.look_at);
}

}  // namespace zproof
