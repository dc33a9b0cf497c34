#include "reports/run_causes.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "reports/wording.h"

namespace zproof {

void CauseVote::note(const ViewResult& view) {
    if (view.outcome != Outcome::defective || !view.diagnosis || !view.diagnosis->cause) return;
    const Explanation& cause = *view.diagnosis->cause;
    auto known = std::ranges::find(causes_, cause.name, &RunCause::name);
    if (known == causes_.end()) known = causes_.insert(known, {cause.name, cause.look_at, cause.fitted});
    if (known->fitted != cause.fitted) known->fitted.clear();
    ++known->views;
    if (cause.saved_share == 0) return;
    known->saved_bits += cause.saved_bits;
    known->all_bits += cause.saved_bits / cause.saved_share;
}

std::vector<EarlierCause> CauseVote::earlier() const {
    std::vector<EarlierCause> earlier;
    for (const RunCause& cause : causes_) earlier.push_back({cause.name, cause.saved_bits, cause.all_bits});
    return earlier;
}

std::vector<RunCause> run_causes(const Results& results) {
    CauseVote vote;
    for (const ViewResult& view : results.views) vote.note(view);
    std::vector<RunCause> causes = vote.causes();
    std::ranges::stable_sort(causes, std::greater{}, [](const RunCause& cause) {
        return std::pair{cause.saved_bits, cause.views};
    });
    return causes;
}

std::uint64_t failed_views(const Results& results) {
    return std::uint64_t(std::ranges::count(results.views, Outcome::defective, &ViewResult::outcome));
}

std::string cause_in_words(const Results& results) {
    const std::uint64_t failed_views = zproof::failed_views(results);
    if (failed_views == 0) return "";
    if (results.diagnosis == CauseSearch::left_out) return "No cause was sought (--no-diagnosis).";
    const std::vector<RunCause> causes = run_causes(results);
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
