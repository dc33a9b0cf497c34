#include "reports/waiver_status.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof {

namespace {

using State = WaiverStatus::State;

/// What one view says of it: the graver word stands.
State state_after(WaiverEffect effect) {
    switch (effect) {
        case WaiverEffect::exceeded:
            return State::exceeded;
        case WaiverEffect::fewer:
            return State::improved;
        case WaiverEffect::holds:
            return State::in_use;
        case WaiverEffect::none:
        case WaiverEffect::expired:
        case WaiverEffect::other_scene:
            return State::unused;
    }
    return State::unused;
}

/// A view without a pixel of it does not take back what another showed.
void merge(WaiverStatus& status, const WaiverUse& use) {
    const State here = state_after(use.effect);
    const bool first = status.views++ == 0;
    status.matched += use.matched;
    status.waived += use.waived;
    if (first || status.state == State::unused)
        status.state = here;
    else if (here != State::unused)
        status.state = std::min(status.state, here);
}

std::string pixels_of(const WaiverStatus& s) { return counted(s.matched, "pixel"); }

}  // namespace

std::string_view name_of(State state) {
    switch (state) {
        case State::expired:
            return "expired";
        case State::exceeded:
            return "exceeded";
        case State::unused:
            return "unused";
        case State::improved:
            return "improved";
        case State::in_use:
            return "in_use";
        case State::not_asked:
            return "not_asked";
    }
    return "not_asked";
}

std::vector<WaiverStatus> waiver_statuses(const Results& results) {
    const std::optional<Day> today = day_from(results.today);
    std::vector<WaiverStatus> statuses;
    for (const Waiver& waiver : results.waivers) {
        WaiverStatus status{.waiver = &waiver};
        for (const ViewResult& view : results.views)
            for (const WaiverUse& use : view.waivers)
                if (use.id == waiver.id) merge(status, use);
        if (today && is_expired(waiver, *today)) status.state = State::expired;
        statuses.push_back(status);
    }
    return statuses;
}

std::string advice_for(const WaiverStatus& s) {
    const Waiver& w = *s.waiver;
    const std::string who = w.origin + ": waiver " + w.id;
    switch (s.state) {
        case State::expired:
            return who + " expired on " + in_words(w.expires) +
                   "; mend the defect and remove it, or renew it with a new reason";
        case State::exceeded:
            return who + " allows " + counted(w.most, "pixel") + " per view and " + pixels_of(s) +
                   " fit it; find out what has grown";
        case State::unused:
            return who + " lets nothing pass any more; remove it (zproof waive prune)";
        case State::improved:
            return who + " expects at least " + counted(w.least, "pixel") + " per view and " + pixels_of(s) +
                   " fit it; lower its count";
        case State::in_use:
        case State::not_asked:
            return "";
    }
    return "";
}

bool fails(const WaiverStatus& status, Strictness strictness) {
    if (status.state == State::expired) return true;
    return strictness == Strictness::strict &&
           (status.state == State::unused || status.state == State::improved);
}

bool waivers_fail(const Results& results) {
    return std::ranges::any_of(waiver_statuses(results),
                               [&](const WaiverStatus& status) { return fails(status, results.strictness); });
}

}  // namespace zproof
