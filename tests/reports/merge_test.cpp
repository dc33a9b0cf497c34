#include "reports/merge.h"

#include <gtest/gtest.h>

#include "reports/json.h"
#include "reports/report_error.h"
#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

ViewResult view_at(std::uint64_t place, const std::string& name) {
    ViewResult v;
    v.scene = "s" + std::to_string(place);
    v.view = name;
    v.place = place;
    return v;
}

Results whole() {
    Results r = waived_run();
    r.selection.scenes = 4;
    r.views = {view_at(0, "a"), view_at(0, "b"), view_at(1, "a"), view_at(2, "a"), view_at(3, "a")};
    return r;
}

/// The scenes dealt round; of more than four shards some are empty.
std::vector<Results> shards_of(const Results& r, int count) {
    std::vector<Results> shards;
    for (int number = 1; number <= count; ++number) {
        Results shard = r;
        shard.shard = {number, count};
        shard.argv = {"run", "room", "--shard", "hash:" + std::to_string(number), "-o", "x"};
        std::erase_if(shard.views, [&](const ViewResult& v) { return int(v.place) % count != number - 1; });
        shards.insert(shards.begin(), shard);
    }
    return shards;
}

std::vector<std::string> names(std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back("shard-" + std::to_string(i));
    return all;
}

std::string refusal(std::vector<Results> shards) {
    try {
        merged(shards, names(shards.size()));
    } catch (const ReportError& e) {
        return e.what();
    }
    return "nothing was refused";
}

}  // namespace

TEST(Merge, GivesWhatOneRunWouldHaveGiven) {
    for (const int count : {1, 2, 3, 4, 7}) {
        const auto shards = shards_of(whole(), count);
        EXPECT_EQ(to_json(merged(shards, names(shards.size()))), to_json(whole())) << count;
    }
}

TEST(Merge, LeavesOutWhatIsOfTheShard) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(without_shard_words({"run", "a", "--shard", "hash:1/2", "-o", "x", "-q", "--out=y", "-oz",
                                   "--shard=hash:2/2", "--oracle", "none", "--out", "w"}),
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
    is_about(changed([](Results& r) { r.ending = Ending::interrupted; }), "interrupted");
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
    shards[0].views.pop_back();
    EXPECT_NE(refusal(shards).find("1 are in no shard"), std::string::npos) << refusal(shards);
}

}  // namespace zproof
