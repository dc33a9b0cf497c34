#include "cli/early_end.h"

#include "reports/wording.h"

namespace zproof {
namespace {

constexpr int most_in_the_same_words = 3;

}  // namespace

void EarlyEnd::note(const ViewResult& view) {
    has_an_answer_ = has_an_answer_ || was_judged(view);
    if (failed(view) && ++failed_ == rule_.max_failed_views)
        why_ = "the run ended after " + counted(std::uint64_t(failed_), "view") +
               " that failed (-x, --max-defects)";
    if (rule_.persistence == Persistence::keeps_going || has_an_answer_) return;
    if (view.outcome != Outcome::unreadable || stands_for_a_scene(view)) return;
    same_words_ = view.message == words_ ? same_words_ + 1 : 1;
    words_ = view.message;
    if (same_words_ == most_in_the_same_words)
        why_ = "the first three views were refused in the same words (--keep-going judges all the same)";
}

}  // namespace zproof
