#include "reports/terminal.h"

#include <gtest/gtest.h>

#include <sstream>

#include "reports/notes.h"
#include "tests/reports/sample.h"

namespace zproof {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string without_colour(std::string text) {
    for (std::size_t i; (i = text.find('\x1b')) != std::string::npos;)
        text.erase(i, text.find('m', i) - i + 1);
    return text;
}

}  // namespace

TEST(Terminal, HasALinePerViewInTheOrderOfTheRun) {
    Results results = sample_results();
    results.views.back().times.load = 0.125;
    const std::vector<std::string> lines = lines_of(summary_table(results, {}));
    ASSERT_GT(lines.size(), 5u);
    EXPECT_TRUE(lines[1].starts_with("✓ proven      meadow/dawn")) << lines[1];
    EXPECT_TRUE(lines[2].starts_with("✗ defective   room/corner")) << lines[2];
    EXPECT_TRUE(lines[3].starts_with("! unreadable  </script>")) << lines[3];
    EXPECT_TRUE(lines[4].starts_with("? not judged  empty/0")) << lines[4];
    EXPECT_TRUE(lines[1].ends_with("  0       0.93        0     7.88")) << lines[1];
}

TEST(Terminal, TellsEachFailureWithItsCommand) {
    const std::string text = summary_table(sample_results(), {});
    EXPECT_NE(text.find("✗ defective  room/corner  against embree\n    2 hole\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n    zproof explain room 812 344\n"), std::string::npos);
    EXPECT_NE(text.find("\n    the scene holds no triangles\n"), std::string::npos);
}

TEST(Terminal, TellsTheLikelyCause) {
    Results results = sample_results();
    EXPECT_NE(
        summary_table(results, {})
            .find("    2 hole\n    likely cause: a row is <lost> (explains 100% of 2 defects); of what it "
                  "leaves: a <tile> is lost: 1 of <16> (explains 100%). Look at <rows>.\n"),
        std::string::npos);
    results.views[1].diagnosis->runners_up[0].saved_share = 0.87;
    EXPECT_EQ(summary_table(results, {}).find("as good"), std::string::npos) << "it explains half as much";
    results.views[1].diagnosis->runners_up[0].explained = 2;
    EXPECT_NE(summary_table(results, {}).find("; as good: only 4 sub-pixel bits;"), std::string::npos);
    results.views[1].diagnosis->runners_up[0].explained = 1;
    results.views[1].diagnosis->cause.reset();
    EXPECT_NE(summary_table(results, {})
                  .find("    no cause is certain; at best, only 4 sub-pixel bits (would explain 50.0% of 2 "
                        "defects)\n"),
              std::string::npos);
}

TEST(Terminal, TellsHowManyDefectsWereTried) {
    Results results = sample_results();
    Diagnosis& diagnosis = *results.views[1].diagnosis;
    diagnosis.defects = 16'000;
    diagnosis.cause->asked = diagnosis.cause->explained = 1000;
    EXPECT_NE(summary_table(results, {}).find("(explains 100% of 1,000 defects tried, of 16,000 in all)"),
              std::string::npos);
}

TEST(Terminal, CountsScenesWhoseViewsAreNotKnown) {
    Results results = sample_results();
    results.views.back().view = "";
    results.views.back().times = {};
    const std::vector<std::string> lines = lines_of(summary_table(results, {}));
    EXPECT_EQ(lines[4], "") << "nobody began with it";
    EXPECT_TRUE(lines[lines.size() - 2].starts_with("3 views and 1 whole scene:  ✓ 1 proven"))
        << lines.back();
}

TEST(Terminal, HasALinePerOracle) {
    const std::string text = summary_table(sample_results(), {});
    EXPECT_NE(
        text.find("\npovray: 1 view, 9 of 2,073,600 pixels, chosen by seed 1, 5 defects, err/bound 0.125\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("\nopengl: not compared in 1 view: no <device>\n"), std::string::npos) << text;
}

TEST(Terminal, FitsTheScreen) {
    const std::vector<std::string> lines = lines_of(summary_table(sample_results(), {.width = 80}));
    EXPECT_EQ(lines[0].find("triangles"), std::string::npos) << lines[0];
    EXPECT_NE(lines[0].find("defects  err/bound  seconds"), std::string::npos) << lines[0];
    EXPECT_EQ(lines[4], "--wide shows every column");
    EXPECT_EQ(summary_table(sample_results(), {.width = 500}), summary_table(sample_results(), {}));
}

TEST(Terminal, TellsViewsThatAreLeftInOneLine) {
    Results results = sample_results();
    ViewResult left = results.views.back();
    left.message = "interrupted before it was judged";
    left.times = {};
    for (int i = 0; i < 141; ++i) left.view = "v" + std::to_string(i), results.views.push_back(left);
    const std::string text = summary_table(results, {});
    EXPECT_NE(
        text.find(
            "\n? not judged  141 views: empty/v0, empty/v1, empty/v2, ...  against embree\n    interrup"),
        std::string::npos)
        << text;
    EXPECT_EQ(text.find("v3"), std::string::npos) << text;
}

TEST(Terminal, TellsNoDepthErrorThatReadsLikeAPass) {
    Results results = sample_results();
    ViewResult& corner = results.views[1];
    corner.counts = {};
    corner.counts[std::size_t(PixelClass::hidden)] = 3;
    corner.candidate_depth.max_error_over_bound = 0.5;
    EXPECT_EQ(error_over_bound_words(corner), "-");
    corner.candidate_depth.max_error_over_bound = 2;
    corner.counts[std::size_t(PixelClass::wrong_depth)] = 1;
    EXPECT_EQ(error_over_bound_words(corner), "2");
}

TEST(Terminal, EndsWithTheTotals) {
    const std::vector<std::string> lines = lines_of(summary_table(sample_results(), {}));
    EXPECT_EQ(lines[lines.size() - 2], "4 views:  ✓ 1 proven  ✗ 1 defective  ! 1 unreadable  ? 1 not judged");
    EXPECT_EQ(lines.back(), "4,147,200 pixels judged: 2 defects, 0 reference defects   15.8 s");
    EXPECT_EQ(lines_of(summary_table({}, {})).back(),
              "0 pixels judged: 0 defects, 0 reference defects   0.0 s");
}

TEST(Terminal, ColourAddsNothingButColour) {
    const std::string plain = summary_table(sample_results(), {});
    const std::string coloured = summary_table(sample_results(), {.colour = Colour::ansi});
    EXPECT_EQ(plain.find('\x1b'), std::string::npos);
    EXPECT_NE(coloured, plain);
    EXPECT_EQ(without_colour(coloured), plain);
}

TEST(Terminal, ANameCannotWriteToTheTerminal) {
    Results results = sample_results();
    results.views[0].scene = "\x1b]0;owned\x07\nsecond line";
    results.views[2].message = "\x1b[2J";
    const std::string text = summary_table(results, {});
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\x07'), std::string::npos);
    EXPECT_EQ(text.find("\nsecond"), std::string::npos);
}

TEST(Terminal, ALongNameKeepsBothEnds) {
    Results results = sample_results();
    results.views[0].scene = std::string(100, 'a') + "ö";
    const std::vector<std::string> lines = lines_of(summary_table(results, {}));
    EXPECT_NE(lines[1].find("aaaaaaaaaaaaaaaaa…aaaaaaaaaaaaö/dawn  "), std::string::npos) << lines[1];
}

TEST(Terminal, TellsEachKindOfNoteOnce) {
    Results results;
    const auto add = [&](const std::string& scene, std::vector<std::string> notes) {
        results.views.emplace_back().scene = scene;
        results.views.back().notes = std::move(notes);
    };
    add("a", {"images not read: 3", "flat: 1"});
    add("a", {"images not read: 3", "flat: 1"});
    add("b", {"flat: 2", "huge", "lost: x", "lost: \x1b[2J"});
    add("c", {"flat: 1", "huge", "away: 1", "away: 2", "away: 3", "away: 4", "away: 5"});
    EXPECT_EQ(note_lines(results),
              "note: a: images not read: 3\nnote: 3 scenes: flat\nnote: 2 scenes: huge\nnote: b: lost: "
              "\\x1b[2J\nnote: b: lost: x\nnote: c: away\n");
    EXPECT_NE(summary_table(results, SummaryStyle{}).find("\n\nnote: a: images not read: 3\n"),
              std::string::npos);
}

TEST(SummaryTable, NamesTheCauseOfTheRunWhereMoreThanOneViewFailed) {
    Results results = sample_results();
    ViewResult failed = results.views[1];
    ASSERT_EQ(failed.outcome, Outcome::defective);
    failed.diagnosis = Diagnosis{};
    failed.diagnosis->cause = Explanation{.name = "all is moved", .description = ""};
    results.views = {failed};
    EXPECT_EQ(summary_table(results, {}).find("Likely cause"), std::string::npos) << "its own story says it";
    results.views = {failed, failed};
    EXPECT_NE(summary_table(results, {}).find("\nLikely cause of all 2 failed views: all is moved.\n"),
              std::string::npos);
}

}  // namespace zproof
