#include "cli/waivers/waiver_file.h"

#include <gtest/gtest.h>

#include "program/usage_error.h"

namespace zproof {
namespace {

const std::string head = "format = 1\n";
const std::string good = R"([[waiver]]
id = "W-1"
scene = "foliage*"
class = ["hidden", "wrong_depth"]
where = { pairs = [[4711, "background"]] }
count = { min = 3, max = 9 }
reason = "a \"known\" sliver"
link = "https://example.org/1"
created = 2026-01-10
expires = 2026-04-10
)";

/// The good waiver with one line changed.
std::string with(const std::string& before, const std::string& after) {
    std::string text = head + good;
    const std::size_t place = text.find(before);
    EXPECT_NE(place, std::string::npos) << before;
    return text.replace(place, before.size(), after);
}

std::string refusal(const std::string& text) {
    try {
        parse_waivers(text, "w.toml");
    } catch (const UsageError& e) {
        return e.what();
    }
    return "nothing was refused";
}

TEST(WaiverFile, IsRead) {
    const std::vector<Waiver> waivers = parse_waivers(head + good, "w.toml");
    ASSERT_EQ(waivers.size(), 1u);
    EXPECT_EQ(waivers[0].scene, "foliage*");
    EXPECT_EQ(waivers[0].view, "*");
    EXPECT_EQ(waivers[0].classes, (std::vector{PixelClass::hidden, PixelClass::wrong_depth}));
    EXPECT_EQ(std::get<AtPairs>(waivers[0].where).pairs[0],
              (std::pair{PrimitiveId{4711}, PrimitiveId::none}));
    EXPECT_EQ(waivers[0].least, 3u);
    EXPECT_EQ(waivers[0].most, 9u);
    EXPECT_EQ(in_words(waivers[0].expires), "2026-04-10");
    EXPECT_EQ(waivers[0].origin, "w.toml:2");
    EXPECT_TRUE(parse_waivers(head, "w.toml").empty());
}

TEST(WaiverFile, KnowsEveryKindOfPlace) {
    const std::string line = "where = { pairs = [[4711, \"background\"]] }";
    const auto where = [&](const std::string& place) {
        return parse_waivers(with(line, place), "w")[0].where;
    };
    EXPECT_EQ(std::get<AtTriangles>(where("where = { triangles = [1, 2] }")).triangles.size(), 2u);
    const auto pixels =
        std::get<AtPixels>(where("where = { rectangles = [[1,2,3,4]], pixels = [[5,6]], size = [8, 7] }"));
    EXPECT_EQ(pixels.size, (Resolution{8, 7}));
    EXPECT_EQ(pixels.rectangles.size(), 2u);
    EXPECT_EQ(pixels.rectangles[1].x, 5);
    EXPECT_TRUE(std::holds_alternative<Anywhere>(where("allow_all = true")));
}

/// What is wrong, the line of the complaint, and what it must say.
struct Mistake {
    std::string text;
    int line;
    std::string said;
};

TEST(WaiverFile, IsRefusedWithItsPlaceAndWhatWasExpected) {
    const std::string where = "where = { pairs = [[4711, \"background\"]] }";
    const std::vector<Mistake> mistakes{
        {good, 1, "'format' is missing"},
        {"format = 2\n", 1, "from 0 to 1"},
        {"format = 0\n", 1, "format 1"},
        {head + "[[waiver]\n", 2, ""},
        {head + "[[waver]]\nid = 'x'\n", 2, "did you mean 'waiver'?"},
        {with("scene =", "scnee ="), 4, "did you mean 'scene'?"},
        {with("\"hidden\"", "\"hiden\""), 5, "did you mean 'hidden'?"},
        {with("\"hidden\"", "\"edge\""), 5, "no class that fails"},
        {with("\"hidden\"", "\"invalid\""), 5, "cannot be waived"},
        {with("[\"hidden\", \"wrong_depth\"]", "[]"), 5, "something in it"},
        {with(where, ""), 2, "allow_all = true"},
        {with(where, "allow_all = false"), 2, "allow_all = true"},
        {with(where, where + "\nallow_all = true"), 7, "remove one"},
        {with(where, "where = { }"), 6, "one kind of place"},
        {with(where, "where = { pairs = [[1,2]], triangles = [1] }"), 6, "one kind of place"},
        {with(where, "where = { pairs = [[1]] }"), 6, "reference's triangle"},
        {with(where, "where = { triangles = [4294967295] }"), 6, "4294967294"},
        {with(where, "where = { triangles = [-1] }"), 6, "whole number"},
        {with(where, "where = { pixels = [[1, 2]] }"), 6, "'size' is missing"},
        {with(where, "where = { rectangles = [[1, 2, 3]], size = [8, 8] }"), 6, "[x, y, width, height]"},
        {with("min = 3", "min = 10"), 7, "min <= max"},
        {with("min = 3, max = 9", "min = 0, max = 0"), 7, "at least 1"},
        {with("max = 9", "max = 9, med = 5"), 7, "unknown key 'med'"},
        {with("count = { min = 3, max = 9 }", "count = 9"), 7, "expected a table"},
        {with("reason = \"a \\\"known\\\" sliver\"", "reason = \"\""), 8, "not empty"},
        {with("reason = \"a \\\"known\\\" sliver\"\n", ""), 2, "'reason' is missing"},
        {with("link = \"https://example.org/1\"\n", ""), 2, "'link' is missing"},
        {with("expires = 2026-04-10\n", ""), 2, "'expires' is missing"},
        {with("2026-04-10", "2026-02-30"), 11, ""},
        {with("2026-04-10", "\"soon\""), 11, "a day such as"},
        {with("2026-04-10", "2026-04-10T10:00:00"), 11, "time of day"},
        {with("2026-04-10", "2026-01-09"), 11, "before created"},
        {with("2026-04-10", "2026-07-10"), 11, "at most 180"},
        {head + good + "scene_sha256 = \"abc\"\n", 12, "64 hexadecimal"},
        {head + good + good, 13, "taken by the waiver in line 2"},
    };
    for (const Mistake& mistake : mistakes) {
        const std::string said = refusal(mistake.text);
        EXPECT_EQ(said.find("w.toml:" + std::to_string(mistake.line) + ":"), 0u) << said << "\n"
                                                                                 << mistake.text;
        EXPECT_NE(said.find(mistake.said), std::string::npos) << said << "\n" << mistake.text;
    }
}

TEST(WaiverFile, AllowsExactlyAHundredAndEightyDays) {
    EXPECT_EQ(in_words(parse_waivers(with("2026-04-10", "2026-07-09"), "w")[0].expires), "2026-07-09");
    EXPECT_NE(refusal(with("2026-04-10", "2026-07-10")).find("choose 2026-07-09"), std::string::npos);
}

TEST(WaiverText, ReadsBackToTheSameWaiver) {
    const std::vector<decltype(Waiver::where)> places{
        Anywhere{}, AtTriangles{{PrimitiveId{1}, PrimitiveId{0xFFFF'FFFE}}},
        AtPairs{{{PrimitiveId{1}, PrimitiveId::none}, {PrimitiveId::none, PrimitiveId{2}}}},
        AtPixels{{8, 6}, {{1, 2, 3, 4}, {0, 0, 1, 1}}}};
    Waiver waiver = parse_waivers(head + good, "w")[0];
    waiver.reason = "quote \" backslash \\ newline \n tab \t \x01 end";
    for (const auto& place : places) {
        waiver.where = place;
        const std::string text = waiver_text(waiver);
        EXPECT_EQ(waiver_text(parse_waivers(head + text, "w")[0]), text);
        EXPECT_EQ(parse_waivers(head + text, "w")[0].reason, waiver.reason);
    }
}

TEST(WaiverText, LosesOnlyTheWaiversThatGo) {
    std::string second = good, third = good;
    second.replace(second.find("W-1"), 3, "W-2");
    third.replace(third.find("W-1"), 3, "W-3");
    const std::string text =
        "# head\n" + head + "\n" + good + "# of two\n" + second + "\n# of three\n" + third;
    EXPECT_EQ(without_waivers(text, {"W-2"}, "w"),
              "# head\n" + head + "\n" + good + "# of two\n\n# of three\n" + third);
    EXPECT_EQ(without_waivers(text, {}, "w"), text);
    EXPECT_TRUE(parse_waivers(without_waivers(text, {"W-1", "W-2", "W-3"}, "w"), "w").empty());
}

TEST(WaiverText, WaiversThatAreNoTablesOfTheirOwnAreLeftToAPerson) {
    const std::string table = R"(id = "W-1", scene = "s", class = "hole", allow_all = true, )"
                              R"(count = { min = 1, max = 2 }, reason = "r", link = "l", )"
                              R"(created = 2026-11-01, expires = 2026-12-01)";
    const std::string list = "format = 1\nwaiver = [{ " + table + " }]\n";
    std::string in_a_text = good;
    in_a_text.replace(in_a_text.find("reason = "), 9, "reason = \"\"\"\n[[waiver]]\n\"\"\"\n# ");
    for (const std::string& text : {list, head + in_a_text}) {
        ASSERT_EQ(parse_waivers(text, "w").size(), 1u);
        try {
            ADD_FAILURE() << without_waivers(text, {"W-1"}, "w.toml");
        } catch (const UsageError& e) {
            EXPECT_STREQ(
                e.what(),
                "w.toml: expected each waiver as a table [[waiver]] of its own; remove by hand: [W-1]");
        }
    }
}

}  // namespace
}  // namespace zproof
