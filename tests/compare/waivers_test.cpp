#include <gtest/gtest.h>

#include "compare/waivers/coverage.h"

namespace zproof {
namespace {

constexpr Day monday{std::chrono::year{2026}, std::chrono::month{4}, std::chrono::day{6}};

Finding defect_at(int x, int y, PixelClass c = PixelClass::hidden) {
    return {.x = x,
            .y = y,
            .verdict = c,
            .candidate = {PrimitiveId(std::uint32_t(x)), 1},
            .reference = {PrimitiveId(std::uint32_t(y)), 1},
            .eps_px = 0,
            .candidate_depth = {},
            .error_over_bound = 0};
}

Waiver waiver_of(decltype(Waiver::where) where, std::uint64_t most = 100) {
    return {.id = "W",
            .scene = "room",
            .view = "*",
            .classes = {PixelClass::hidden, PixelClass::wrong_depth},
            .where = std::move(where),
            .least = 1,
            .most = most,
            .reason = "known",
            .link = "https://example.org/1",
            .created = monday,
            .expires = monday,
            .scene_sha256 = "",
            .origin = "w:1"};
}

const WaivedView room{.scene = "room", .view = "main", .scene_sha256 = "aa", .size = {8, 6}};

WaiverCoverage covered(const std::vector<Waiver>& waivers, const std::vector<Finding>& findings) {
    return cover(waivers, room, findings, monday);
}

/// Which of the findings pass.
std::vector<bool> passing(const Waiver& waiver, const std::vector<Finding>& findings) {
    std::vector<bool> pass;
    for (const auto& by : covered({waiver}, findings).by) pass.push_back(by.has_value());
    return pass;
}

using Passes = std::vector<bool>;

TEST(Waivers, SpeakOfTheirPlaceOnly) {
    const std::vector<Finding> findings{defect_at(1, 2), defect_at(2, 1), defect_at(3, 1), defect_at(3, 4)};
    EXPECT_EQ(passing(waiver_of(Anywhere{}), findings), (Passes{true, true, true, true}));
    EXPECT_EQ(passing(waiver_of(AtTriangles{{PrimitiveId{1}}}), findings), (Passes{true, true, true, false}));
    EXPECT_EQ(passing(waiver_of(AtPairs{{{PrimitiveId{1}, PrimitiveId{2}}}}), findings),
              (Passes{true, false, false, false}));
    EXPECT_EQ(passing(waiver_of(AtPixels{{8, 6}, {{2, 1, 2, 3}}}), findings),
              (Passes{false, true, true, false}));
}

TEST(Waivers, OfATriangleDoNotSpeakOfBackground) {
    Finding hole = defect_at(1, 2);
    hole.candidate.primitive = hole.reference.primitive = PrimitiveId::none;
    EXPECT_EQ(passing(waiver_of(AtTriangles{{PrimitiveId::none}}), {hole}), Passes{false});
    EXPECT_EQ(passing(waiver_of(AtPairs{{{PrimitiveId::none, PrimitiveId::none}}}), {hole}), Passes{true});
}

TEST(Waivers, SpeakOfTheirClassesAndNeverOfInvalidOrPassingPixels) {
    Waiver all = waiver_of(Anywhere{});
    all.classes.clear();
    for (int i = 0; i < pixel_class_count; ++i) all.classes.push_back(PixelClass(i));
    for (int i = 0; i < pixel_class_count; ++i) {
        const auto c = PixelClass(i);
        EXPECT_EQ(passing(all, {defect_at(0, 0, c)}), Passes{is_defect(c) && c != PixelClass::invalid})
            << name_of(c);
    }
    EXPECT_EQ(passing(waiver_of(Anywhere{}), {defect_at(0, 0, PixelClass::hole)}), Passes{false});
}

TEST(Waivers, LetNothingPassBeyondTheirCount) {
    const std::vector<Finding> three{defect_at(1, 0), defect_at(2, 0), defect_at(3, 0)};
    for (std::uint64_t most = 0; most < 5; ++most) {
        const WaiverCoverage c = covered({waiver_of(Anywhere{}, most)}, three);
        EXPECT_EQ(c.uses[0].effect, most < 3 ? WaiverEffect::exceeded : WaiverEffect::holds);
        EXPECT_EQ(c.uses[0].waived, most < 3 ? 0u : 3u);
        EXPECT_EQ(c.uses[0].matched, 3u);
        EXPECT_EQ(c.by[0].has_value(), most >= 3);
    }
}

TEST(Waivers, SayWhenTheyAllowTooMuch) {
    Waiver generous = waiver_of(Anywhere{});
    generous.least = 2;
    EXPECT_EQ(covered({generous}, {defect_at(1, 0)}).uses[0].effect, WaiverEffect::fewer);
    EXPECT_EQ(covered({generous}, {defect_at(1, 0)}).uses[0].waived, 1u);
    EXPECT_EQ(covered({generous}, {}).uses[0].effect, WaiverEffect::none);
}

TEST(Waivers, HoldThroughTheirLastDay) {
    const std::vector<Waiver> waivers{waiver_of(Anywhere{})};
    const std::vector<Finding> findings{defect_at(1, 0)};
    const Day tuesday{std::chrono::sys_days{monday} + std::chrono::days{1}};
    EXPECT_TRUE(cover(waivers, room, findings, monday).by[0]);
    EXPECT_FALSE(cover(waivers, room, findings, tuesday).by[0]);
    EXPECT_EQ(cover(waivers, room, findings, tuesday).uses[0].effect, WaiverEffect::expired);
}

TEST(Waivers, DieWithTheSceneAndTheSizeTheyWereWrittenFor) {
    Waiver bound = waiver_of(Anywhere{});
    bound.scene_sha256 = "aa";
    EXPECT_EQ(passing(bound, {defect_at(1, 0)}), Passes{true});
    bound.scene_sha256 = "ab";
    EXPECT_EQ(passing(bound, {defect_at(1, 0)}), Passes{false});
    EXPECT_EQ(covered({bound}, {defect_at(1, 0)}).uses[0].effect, WaiverEffect::other_scene);
    EXPECT_EQ(passing(waiver_of(AtPixels{{8, 7}, {{0, 0, 8, 6}}}), {defect_at(1, 0)}), Passes{false});
}

TEST(Waivers, OfOtherScenesAndViewsAreIgnored) {
    Waiver other = waiver_of(Anywhere{});
    other.scene = "roo";
    EXPECT_TRUE(covered({other}, {defect_at(1, 0)}).uses.empty());
    other.scene = "r*m", other.view = "ma?n";
    EXPECT_EQ(covered({other}, {defect_at(1, 0)}).uses.size(), 1u);
    other.view = "back";
    EXPECT_TRUE(covered({other}, {defect_at(1, 0)}).uses.empty());
}

TEST(Waivers, AreChargedOncePerPixelTheFirstThatHolds) {
    std::vector<Waiver> waivers{waiver_of(Anywhere{}, 1), waiver_of(AtTriangles{{PrimitiveId{1}}}),
                                waiver_of(Anywhere{})};
    const WaiverCoverage c = covered(waivers, {defect_at(1, 0), defect_at(2, 0)});
    EXPECT_EQ(c.by[0], 1u);
    EXPECT_EQ(c.by[1], 2u);
    EXPECT_EQ(c.uses[2].waived, 1u);
    EXPECT_EQ(c.uses[2].matched, 2u);
}

TEST(Patterns, AreOfStarsAndQuestionMarks) {
    for (const auto& [pattern, text] : std::vector<std::pair<const char*, const char*>>{
             {"", ""}, {"*", ""}, {"*", "x"}, {"a*c", "abbc"}, {"a*c*", "acbc"}, {"?", "x"}, {"**a", "a"}})
        EXPECT_TRUE(fits(pattern, text)) << pattern << " " << text;
    for (const auto& [pattern, text] : std::vector<std::pair<const char*, const char*>>{
             {"", "x"}, {"?", ""}, {"a*c", "abcd"}, {"room", "room2"}, {"Room", "room"}, {"*a", "ab"}})
        EXPECT_FALSE(fits(pattern, text)) << pattern << " " << text;
}

TEST(Days, AreOfTheCalendar) {
    EXPECT_EQ(in_words(*day_from("2028-02-29")), "2028-02-29");
    for (const char* text : {"", "2026-02-29", "2026-13-01", "2026-1-1", "2026-01-32", "2026/01/01",
                             "2026-01-0x", "+026-01-01", "2026-01-011"})
        EXPECT_FALSE(day_from(text)) << text;
}

}  // namespace
}  // namespace zproof
