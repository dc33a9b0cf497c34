#include "cli/outcome_code.h"

#include <algorithm>

#include "reports/waiver_status.h"

namespace zproof {

ExitCode exit_code_of(const Results& results) {
    const auto any = [&](Outcome outcome) {
        return std::ranges::count(results.views, outcome, &ViewResult::outcome) > 0;
    };
    if (any(Outcome::internal_error)) return ExitCode::internal;
    if (results.ending == Ending::interrupted) return ExitCode::interrupted;
    if (results.ending == Ending::partial || any(Outcome::unreadable)) return ExitCode::cannot_judge;
    if (any(Outcome::defective)) return ExitCode::defect;
    if (any(Outcome::undecided)) return ExitCode::cannot_judge;
    if (!any(Outcome::proven)) return ExitCode::nothing;
    return waivers_fail(results) ? ExitCode::defect : ExitCode::proven;
}

ExitCode worst_of(const std::vector<ExitCode>& codes) {
    using enum ExitCode;
    for (const ExitCode code : {internal, interrupted, cannot_judge, defect, proven, nothing})
        if (std::ranges::count(codes, code) > 0) return code;
    return nothing;
}

std::string_view in_words(ExitCode code) {
    switch (code) {
        case ExitCode::proven:
            return "proven";
        case ExitCode::defect:
            return "defect";
        case ExitCode::usage:
            return "not understood";
        case ExitCode::cannot_judge:
            return "cannot judge everything";
        case ExitCode::nothing:
            return "nothing judged";
        case ExitCode::internal:
            return "internal error";
        case ExitCode::interrupted:
            return "interrupted";
    }
    return "";
}

}  // namespace zproof
