// Verdicts on whole runs that the faultless renderer of this project cannot be made to give.
#include "cli/outcome_code.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

Results run_of(std::initializer_list<Outcome> outcomes) {
    Results results;
    for (const Outcome outcome : outcomes) results.views.emplace_back().outcome = outcome;
    return results;
}

ExitCode code_of(std::initializer_list<Outcome> outcomes) { return exit_code_of(run_of(outcomes)); }

TEST(ExitCode, IsOfTheOutcomeThatProvedLeast) {
    using enum Outcome;
    EXPECT_EQ(code_of({proven, proven}), ExitCode::proven);
    EXPECT_EQ(code_of({proven, not_judged}), ExitCode::proven);
    EXPECT_EQ(code_of({proven, defective, proven}), ExitCode::defect);
    EXPECT_EQ(code_of({defective, not_judged}), ExitCode::defect);
    EXPECT_EQ(code_of({not_judged, not_judged}), ExitCode::nothing);
    EXPECT_EQ(code_of({}), ExitCode::nothing);
    EXPECT_EQ(code_of({proven, defective, unreadable}), ExitCode::cannot_judge);
    EXPECT_EQ(code_of({not_judged, unreadable}), ExitCode::cannot_judge);
    Results interrupted = run_of({defective, unreadable});
    interrupted.ending = Ending::interrupted;
    EXPECT_EQ(exit_code_of(interrupted), ExitCode::interrupted);
}

TEST(ExitCode, OfSeveralRunsIsTheOneThatProvesLeast) {
    using enum ExitCode;
    EXPECT_EQ(worst_of({proven, defect, proven}), defect);
    EXPECT_EQ(worst_of({defect, cannot_judge}), cannot_judge);
    EXPECT_EQ(worst_of({interrupted, internal, cannot_judge}), internal);
    EXPECT_EQ(worst_of({nothing, proven}), proven);  // a shard may have nothing to judge of one renderer
    EXPECT_EQ(worst_of({nothing, nothing}), nothing);
    EXPECT_EQ(worst_of({}), nothing);
}

TEST(ExitCode, OfAPartialMergeProvesNothing) {
    Results partial = run_of({Outcome::proven});
    partial.ending = Ending::partial;
    EXPECT_EQ(exit_code_of(partial), ExitCode::cannot_judge);
}

}  // namespace
}  // namespace zproof
