#include "reports/merge.h"

#include <gtest/gtest.h>

#include "reports/json.h"
#include "reports/report_error.h"
#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

ViewResult view_at(std::uint64_t place, std::uint64_t view_place, std::uint64_t scene_views) {
    ViewResult v;
    v.scene = "s" + std::to_string(place);
    v.view = "v" + std::to_string(view_place);
    v.place = place;
    v.view_place = view_place;
    v.scene_views = scene_views;
    return v;
}

/// Stands for a scene that could not be read.
ViewResult unreadable_at(std::uint64_t place) {
    ViewResult v;
    v.scene = "s" + std::to_string(place);
    v.place = place;
    v.outcome = Outcome::unreadable;
    return v;
}

Results whole() {
    Results r = waived_run();
    r.selection.scenes = 4;
    r.views = {view_at(0, 0, 3), view_at(0, 1, 3), view_at(0, 2, 3),
               view_at(1, 0, 1), unreadable_at(2), view_at(3, 0, 1)};
    return r;
}

/// The views dealt round; of many shards some are empty.
std::vector<Results> shards_of(const Results& r, int count) {
    std::vector<Results> shards;
    for (int number = 1; number <= count; ++number) {
        Results shard = r;
        shard.shard = {number, count};
        shard.argv = {"run", "room", "--shard", "hash:" + std::to_string(number), "-o", "x"};
        std::erase_if(shard.views,
                      [&](const ViewResult& v) { return int(v.place + v.view_place) % count != number - 1; });
        shards.insert(shards.begin(), shard);
    }
    return shards;
}

Merging merging_of(const std::vector<Results>& shards) {
    Merging merging;
    for (std::size_t i = 0; i < shards.size(); ++i) merging.add(shards[i], "shard-" + std::to_string(i));
    return merging;
}

Results merged(const std::vector<Results>& shards) { return merging_of(shards).whole(); }

std::string refusal(const std::vector<Results>& shards) {
    try {
        merged(shards);
    } catch (const ReportError& e) {
        return e.what();
    }
    return "nothing was refused";
}

}  // namespace

TEST(Merge, GivesWhatOneRunWouldHaveGiven) {
    for (const int count : {1, 2, 3, 4, 7}) {
        const auto shards = shards_of(whole(), count);
        EXPECT_EQ(to_json(merged(shards)), to_json(whole())) << count;
    }
}

TEST(Merge, LeavesOutWhatIsOfTheShard) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(without_shard_words({"run", "a", "--shard", "hash:1/2", "-o", "x", "-q", "--out=y", "-oz",
                                   "--shard=hash:2/2", "--oracle", "none", "--out", "w", "--exit-zero",
                                   "--empty-shard", "ok", "--empty-shard=ok"}),
              (Words{"run", "a", "-q", "--oracle", "none"}));
}

TEST(Merge, RefusesWhatIsNotOneRun) {
    const auto changed = [](const auto& change) {
        auto shards = shards_of(whole(), 3);
        change(shards[1]);
        return refusal(shards);
    };
    const auto is_about = [](const std::string& text, const std::string& what) {
        EXPECT_TRUE(text.starts_with("shard-1: ") && text.find(what) != std::string::npos) << text;
    };
    is_about(changed([](Results& r) { r.version = "9"; }), "version");
    is_about(changed([](Results& r) { r.commit = "9"; }), "commit");
    is_about(changed([](Results& r) { r.embree = "9"; }), "Embree");
    is_about(changed([](Results& r) { r.renderers = {{"mine", "1", "{}"}}; }), "renderers");
    is_about(changed([](Results& r) { r.selection.sha256 = std::string(64, 'c'); }), "resolution");
    is_about(changed([](Results& r) { r.selection.sha256 = ""; }), "older");
    is_about(changed([](Results& r) { r.shard.count = 4; }), "number of shards");
    is_about(changed([](Results& r) { r.waivers.pop_back(); }), "waivers");
    is_about(changed([](Results& r) { r.today = "2026-04-11"; }), "--now");
    is_about(changed([](Results& r) { r.strictness = Strictness::strict; }), "--strict");
    is_about(changed([](Results& r) { r.diagnosis = CauseSearch::left_out; }), "--no-diagnosis");
    is_about(changed([](Results& r) { r.ending = Ending::interrupted; }), "interrupted");
    is_about(changed([](Results& r) { r.ending = Ending::stopped; }), "was stopped; run shard");
}

TEST(Merge, RefusesMissingAndDoubledShards) {
    auto shards = shards_of(whole(), 3);
    shards.pop_back();
    EXPECT_NE(refusal(shards).find("shard hash:1/3 is missing"), std::string::npos) << refusal(shards);
    shards.push_back(shards.back());
    EXPECT_NE(refusal(shards).find("and so is shard-1"), std::string::npos) << refusal(shards);
    EXPECT_NE(refusal({}), "nothing was refused");
}

TEST(Merge, RefusesAShardThatLostAScene) {
    auto shards = shards_of(whole(), 2);
    std::erase_if(shards[0].views, [](const ViewResult& v) { return v.place == 3; });
    std::erase_if(shards[1].views, [](const ViewResult& v) { return v.place == 3; });
    EXPECT_NE(refusal(shards).find("1 are in no shard"), std::string::npos) << refusal(shards);
}

TEST(Merge, RefusesAShardThatLostAView) {
    auto shards = shards_of(whole(), 2);
    for (Results& shard : shards)
        std::erase_if(shard.views, [](const ViewResult& v) { return v.place == 0 && v.view_place == 1; });
    EXPECT_NE(refusal(shards).find("1 views of scenes"), std::string::npos) << refusal(shards);
}

TEST(Merge, RefusesASceneThatWasChangedBetweenShards) {
    Results one = whole();
    for (ViewResult& view : one.views) view.scene_sha256 = std::string(64, 'a');
    auto shards = shards_of(one, 3);
    EXPECT_EQ(to_json(merged(shards)), to_json(one));
    shards[0].views.front().scene_sha256 = std::string(64, 'b');
    EXPECT_NE(refusal(shards).find("different contents of scene s0"), std::string::npos) << refusal(shards);
}

TEST(Merge, RefusesAViewThatTwoShardsJudged) {
    auto shards = shards_of(whole(), 2);
    shards[0].views.push_back(shards[1].views.front());
    EXPECT_NE(refusal(shards).find("is in two shards"), std::string::npos) << refusal(shards);
}

TEST(Merge, TakesWhatSeveralShardsSayOfAWholeSceneOnce) {
    auto shards = shards_of(whole(), 3);
    for (Results& shard : shards)
        if (std::ranges::count(shard.views, std::uint64_t{2}, &ViewResult::place) == 0)
            shard.views.push_back(unreadable_at(2));
    EXPECT_EQ(to_json(merged(shards)), to_json(whole()));
}

TEST(Merge, HoldsASceneToItsExpectationsWhoeverJudgedItsViews) {
    Results one = whole();
    for (ViewResult& view : one.views)
        if (view.place == 0) view.expects = {"edge"};
    EXPECT_EQ(merged(shards_of(one, 3)).views[2].outcome, Outcome::defective);
    one.views[0].counts[std::size_t(PixelClass::edge)] = 1;
    EXPECT_EQ(merged(shards_of(one, 3)).views[2].outcome, Outcome::proven);
}

TEST(Merge, OfSomeShardsPutsTheMissingViewsInTheirPlaces) {
    auto shards = shards_of(whole(), 3);
    std::vector<ViewResult> missing = shards[1].views;
    for (ViewResult& view : missing) view.outcome = Outcome::not_judged;
    ASSERT_FALSE(missing.empty());
    shards.erase(shards.begin() + 1);
    Results some = merging_of(shards).partial(missing);
    EXPECT_EQ(some.ending, Ending::partial);
    ASSERT_EQ(some.views.size(), whole().views.size());
    std::size_t not_judged = 0;
    for (std::size_t i = 0; i < some.views.size(); ++i) {
        EXPECT_EQ(some.views[i].scene, whole().views[i].scene);
        EXPECT_EQ(some.views[i].view, whole().views[i].view);
        if (some.views[i].outcome == Outcome::not_judged) ++not_judged;
    }
    EXPECT_EQ(not_judged, missing.size());
}

}  // namespace zproof
