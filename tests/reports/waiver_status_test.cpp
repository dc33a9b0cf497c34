#include "reports/waiver_status.h"

#include <gtest/gtest.h>

#include "reports/formats.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/terminal.h"
#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

using State = WaiverStatus::State;

std::vector<State> states_of(const Results& results) {
    std::vector<State> states;
    for (const WaiverStatus& status : waiver_statuses(results)) states.push_back(status.state);
    return states;
}

Results with_effects(std::initializer_list<WaiverEffect> effects) {
    Results r = waived_run();
    r.waivers = {r.waivers[0]};
    const ViewResult view = r.views[0];
    r.views.clear();
    for (const WaiverEffect effect : effects) {
        r.views.push_back(view);
        r.views.back().waivers = {{"holds", effect, 1, 1}};
    }
    return r;
}

bool holds_text(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(WaiverStatus, IsTheStateThatEveryViewTogetherGives) {
    EXPECT_EQ(states_of(waived_run()), (std::vector{State::in_use, State::improved, State::exceeded,
                                                    State::expired, State::unused, State::not_asked}));
}

TEST(WaiverStatus, OfSeveralViewsIsTheGravestButAnEmptyOneTakesNothingBack) {
    using enum WaiverEffect;
    EXPECT_EQ(states_of(with_effects({none, holds})), std::vector{State::in_use});
    EXPECT_EQ(states_of(with_effects({holds, none})), std::vector{State::in_use});
    EXPECT_EQ(states_of(with_effects({holds, fewer})), std::vector{State::improved});
    EXPECT_EQ(states_of(with_effects({fewer, exceeded, holds})), std::vector{State::exceeded});
    EXPECT_EQ(states_of(with_effects({none, none})), std::vector{State::unused});
    EXPECT_EQ(states_of(with_effects({other_scene})), std::vector{State::unused});
    EXPECT_EQ(states_of(with_effects({})), std::vector{State::not_asked});
}

TEST(WaiverStatus, FailsTheGateWhereExpiredAndIfStrictWhereNotNeeded) {
    const Results run = waived_run();
    for (const WaiverStatus& s : waiver_statuses(run)) {
        EXPECT_EQ(fails(s, Strictness::lenient), s.state == State::expired) << s.waiver->id;
        EXPECT_EQ(fails(s, Strictness::strict),
                  s.state == State::expired || s.state == State::unused || s.state == State::improved)
            << s.waiver->id;
        EXPECT_EQ(advice_for(s).empty(), s.state == State::in_use || s.state == State::not_asked);
    }
}

TEST(WaiverStatus, HoldsThroughTheLastDay) {
    Results r = with_effects({WaiverEffect::holds});
    EXPECT_FALSE(waivers_fail(r));
    r.today = "2026-04-11";
    EXPECT_TRUE(waivers_fail(r));
}

TEST(WaivedRun, ReadsBackToTheSameResults) {
    const std::string text = to_json(waived_run());
    EXPECT_EQ(to_json(results_from_json(text)), text);
    const Results back = results_from_json(text);
    EXPECT_EQ(back.views[0].waived, waived_run().views[0].waived);
    EXPECT_EQ(back.views[0].worst[2].waiver, "holds");
    EXPECT_EQ(states_of(back), states_of(waived_run()));
    EXPECT_EQ(back.argv, waived_run().argv);
}

TEST(WaivedRun, KeepsEveryPlaceOfAWaiver) {
    Results r = waived_run();
    r.waivers[0].where = Anywhere{};
    r.waivers[1].where = AtTriangles{{PrimitiveId{0xFFFF'FFFE}, PrimitiveId{0}}};
    r.waivers[2].where = AtPixels{{8, 6}, {{1, 2, 3, 4}}};
    const Results back = results_from_json(to_json(r));
    EXPECT_TRUE(std::holds_alternative<Anywhere>(back.waivers[0].where));
    EXPECT_EQ(std::get<AtTriangles>(back.waivers[1].where).triangles[0], PrimitiveId{0xFFFF'FFFE});
    EXPECT_EQ(std::get<AtPixels>(back.waivers[2].where).rectangles[0].height, 4);
    EXPECT_EQ(std::get<AtPairs>(back.waivers[3].where).pairs[0].second, PrimitiveId::none);
}

TEST(WaivedRun, ShowsWaivedPixelsInEveryReport) {
    const Results r = waived_run();
    const std::string table = summary_table(r, {});
    EXPECT_TRUE(holds_text(table, "2 (3 waived)")) << table;
    EXPECT_TRUE(holds_text(table, "3 hidden (1 waived), 2 wrong_depth (2 waived)")) << table;
    const std::string junit = to_junit(r);
    EXPECT_TRUE(holds_text(junit, "1 defective pixel let pass by waiver holds")) << junit;
    EXPECT_TRUE(holds_text(junit, "message=\"2 defective pixels, 2 hidden\"")) << junit;
    const std::string html = to_html(r, "/nowhere");
    EXPECT_TRUE(holds_text(html, "defect, waived"));
    EXPECT_TRUE(holds_text(html, "waived by <code>holds</code>"));
}

TEST(WaivedRun, PassesInJunitWithANoteWhereAllIsWaived) {
    Results r = waived_run();
    r.views[0].waived = r.views[0].counts;
    r.views[0].outcome = Outcome::proven;
    const std::string junit = to_junit(r);
    EXPECT_FALSE(holds_text(junit, "<failure"));
    EXPECT_TRUE(holds_text(junit, "let pass by waiver"));
}

}  // namespace zproof
