// Verdicts on whole runs that the faultless renderer of this project cannot be made to give.
#include "cli/outcome_code.h"

#include <gtest/gtest.h>

#include "cli/expectations.h"

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

ViewResult view_showing(std::initializer_list<PixelClass> classes) {
    ViewResult view;
    for (const PixelClass c : classes) view.counts[std::size_t(c)] = 1;
    return view;
}

const SceneSource expects_edge_and_clip{
    .name = "s", .origin = "suite", .reason = "r", .expects = {"edge", "clip"}};

TEST(Expectations, AreMetByAllViewsTogether) {
    std::vector<ViewResult> views{view_showing({PixelClass::edge}), view_showing({PixelClass::clip})};
    hold_to_expectations(expects_edge_and_clip, views);
    EXPECT_EQ(views[0].outcome, Outcome::proven);
    EXPECT_EQ(views[1].outcome, Outcome::proven);
}

TEST(Expectations, FailTheSceneThatNoLongerShowsAClass) {
    std::vector<ViewResult> views{view_showing({PixelClass::edge}), view_showing({PixelClass::agree})};
    hold_to_expectations(expects_edge_and_clip, views);
    EXPECT_EQ(views[1].outcome, Outcome::defective);
    EXPECT_NE(views[1].message.find("class clip "), std::string::npos) << views[1].message;
}

}  // namespace
}  // namespace zproof
