#include "reports/waiver_standing.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof {

namespace {

using State = WaiverStanding::State;

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
void merge(WaiverStanding& standing, const WaiverUse& use) {
    const State here = state_after(use.effect);
    const bool first = standing.views++ == 0;
    standing.matched += use.matched;
    standing.waived += use.waived;
    if (first || standing.state == State::unused)
        standing.state = here;
    else if (here != State::unused)
        standing.state = std::min(standing.state, here);
}

std::string pixels_of(const WaiverStanding& s) { return counted(s.matched, "pixel"); }

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

std::vector<WaiverStanding> waiver_standings(const Results& results) {
    const std::optional<Day> today = day_from(results.today);
    std::vector<WaiverStanding> standings;
    for (const Waiver& waiver : results.waivers) {
        WaiverStanding standing{.waiver = &waiver};
        for (const ViewResult& view : results.views)
            for (const WaiverUse& use : view.waivers)
                if (use.id == waiver.id) merge(standing, use);
        if (today && is_expired(waiver, *today)) standing.state = State::expired;
        standings.push_back(standing);
    }
    return standings;
}

std::string advice_for(const WaiverStanding& s) {
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

bool fails(const WaiverStanding& standing, Strictness strictness) {
    if (standing.state == State::expired) return true;
    return strictness == Strictness::strict &&
           (standing.state == State::unused || standing.state == State::improved);
}

bool waivers_fail(const Results& results) {
    return std::ranges::any_of(waiver_standings(results), [&](const WaiverStanding& standing) {
        return fails(standing, results.strictness);
    });
}

}  // namespace zproof
