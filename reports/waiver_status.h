/// What a run as a whole says of each waiver.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

struct WaiverStatus {
    enum class State {
        expired,    ///< it has run out: fails the gate, whatever the pixels say
        exceeded,   ///< more pixels than it allows in some view, whose defects fail by themselves
        unused,     ///< its views were judged and not one of its pixels is a defect
        improved,   ///< fewer pixels than it says in some view
        in_use,     ///< as it says
        not_asked,  ///< no view that it names was judged
    };
    const Waiver* waiver = nullptr;
    State state = State::not_asked;
    std::uint64_t views = 0;  ///< judged ones that it names
    std::uint64_t matched = 0, waived = 0;
};

std::string_view name_of(WaiverStatus::State state);

/// The statuses in the order of the file. They point into the results.
std::vector<WaiverStatus> waiver_statuses(const Results& results);
std::vector<WaiverStatus> waiver_statuses(Results&& results) = delete;

/// Why this status needs a person's hand: one sentence with what to do; empty where it needs none.
std::string advice_for(const WaiverStatus& status);

/// Does the status fail the gate by itself? An expired one does; unused and improved ones do if strict.
bool fails(const WaiverStatus& status, Strictness strictness);
bool waivers_fail(const Results& results);

}  // namespace zproof
