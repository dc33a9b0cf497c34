#include "cli/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace zproof {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::MatchesRegex;

TEST(TimeLeft, InWords) {
    EXPECT_EQ(time_left(-3), "0:00 left");
    EXPECT_EQ(time_left(125.4), "2:05 left");
    EXPECT_EQ(time_left(3723), "1:02:03 left");
}

TEST(TimeLeft, IsToldWhereItIsAnEstimate) {
    const Measured none{.seconds = 0, .done = 0, .all = 4}, quarter{.seconds = 10, .done = 1, .all = 4},
        half{.seconds = 20, .done = 2, .all = 4}, all{.seconds = 40, .done = 4, .all = 4},
        nearly{.seconds = 40, .done = 99, .all = 100};
    using enum Estimate;
    EXPECT_EQ(left_in_words(none, from_the_start), "");
    EXPECT_EQ(left_in_words(quarter, from_the_start), "  0:30 left");
    EXPECT_EQ(left_in_words(quarter, from_half_of_the_work), "");
    EXPECT_EQ(left_in_words(half, from_half_of_the_work), "  0:20 left");
    EXPECT_EQ(left_in_words(all, from_the_start), "");
    EXPECT_EQ(left_in_words(nearly, from_the_start), "") << "0:00 left";
}

TEST(WorkProgress, CountsWorkAndNotPieces) {
    std::ostringstream out;
    {
        WorkProgress progress{out, ProgressStyle::lines, 4};
        progress.within("room: ");
        progress.begin("long", 3);
        progress.begin("short");
        progress.expect_more(4);
        progress.begin("more");
    }
    EXPECT_THAT(out.str(), MatchesRegex("\\[  0%\\] room: long\n"
                                        "\\[ 75%\\] room: short(  [0-9:]+ left)?\n"
                                        "\\[ 50%\\] room: more(  [0-9:]+ left)?\n"));
}

TEST(WorkProgress, ItsBarMakesWayForResultsAndGoes) {
    std::ostringstream out;
    {
        WorkProgress progress{out, ProgressStyle::bar, 2};
        progress.begin("first");
        progress.say(out, "result\n");
    }
    EXPECT_EQ(out.str(),
              "\r\x1b[K[........................]   0%  first"
              "\r\x1b[Kresult\n"
              "\r\x1b[K");
}

TEST(WorkProgress, SaysNothingWhereNobodyWantsIt) {
    std::ostringstream out, results;
    {
        WorkProgress progress{out, ProgressStyle::none, 2};
        progress.begin("first");
        progress.mention("stage");
        progress.say(results, "result\n");
    }
    EXPECT_EQ(out.str(), "");
    EXPECT_EQ(results.str(), "result\n");
}

ViewResult view_of(const std::string& scene, double seconds) {
    ViewResult view;
    view.scene = scene;
    view.times.judge = seconds;
    return view;
}

TEST(ExpectedWork, IsWhatTheLastRunTook) {
    Results earlier;
    earlier.views = {view_of("a", 1), view_of("a", 3), view_of("b", 8), view_of("other", 99)};
    const auto work = [](double w) { return Field(&SceneWork::work, w); };
    EXPECT_THAT(expected_work({"b", "a", "new"}, earlier), ElementsAre(work(8), work(4), work(6)));
    EXPECT_THAT(expected_work({"b", "a"}, {}), ElementsAre(work(1), work(1)));
}

/// The bar of a scene moves with its views.
TEST(RunProgress, SharesAScenesWorkOutAmongItsViews) {
    std::ostringstream out;
    {
        Progress progress{out, ProgressStyle::bar, {{"a", 1}, {"b", 3}}};
        progress.begin_scene("a");
        progress.finish_scene();
        progress.begin_scene("b");
        progress.expect_views(3);
        progress.end_view();
        out.str("");
        progress.begin_stage("trace main");
    }
    EXPECT_THAT(out.str(), testing::HasSubstr("[############............]  50%"));
    EXPECT_THAT(out.str(), testing::HasSubstr("  b: trace main"));
}

TEST(RunProgress, TellsNoTimeOfWhatWasNotBegun) {
    std::ostringstream out;
    Progress progress{out, ProgressStyle::lines, {{"a", 1}}};
    progress.begin_scene("a");
    progress.tell(view_of("a", 2));
    ViewResult left = view_of("a", 0);
    left.view = "main";
    left.outcome = Outcome::not_judged;
    left.message = "interrupted before it was judged";
    progress.tell(left);
    EXPECT_EQ(out.str(),
              "[1/1] proven      a: err/bound 0  2.0 s\n"
              "[1/1] not_judged  a / main: interrupted before it was judged\n");
}

}  // namespace
}  // namespace zproof
