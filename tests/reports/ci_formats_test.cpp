// What CI servers and spreadsheets are given: github, md, csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "reports/formats.h"
#include "tests/reports/sample.h"
#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// So many defective views, the last the worst.
Results many(int views) {
    Results r;
    for (int i = 0; i < views; ++i) {
        ViewResult& v = r.views.emplace_back();
        v.scene = "s" + std::to_string(i);
        v.view = "v";
        v.source = "suite";
        v.outcome = Outcome::defective;
        v.counts[std::size_t(PixelClass::hole)] = std::uint64_t(i + 1);
    }
    return r;
}

std::size_t fields_of(const std::string& line) {
    bool quoted = false;
    std::size_t count = 1;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) ++count;
    }
    return count;
}

}  // namespace

// https://docs.github.com/actions/reference/workflow-commands-for-github-actions
TEST(GitHub, EscapesAsItsRunnerReads) {
    EXPECT_EQ(github_message("50%\na:b,c"), "50%25%0Aa:b,c");
    EXPECT_EQ(github_property("50%\na:b,c"), "50%25%0Aa%3Ab%2Cc");
    EXPECT_EQ(github_message("a\r\nb").find('\r'), std::string::npos);
}

TEST(GitHub, NamesTheWorstFirstAndNeverMoreThanAreShown) {
    for (const int views : {1, 10, 11, 25}) {
        const auto lines = lines_of(to_github(many(views)));
        const auto errors =
            std::ranges::count_if(lines, [](const auto& l) { return l.starts_with("::error "); });
        EXPECT_EQ(errors, std::min(views, 10));
        EXPECT_EQ(lines[0].find("title=zproof%3A s" + std::to_string(views - 1) + "/v defective::"),
                  std::string{"::error "}.size())
            << lines[0];
        EXPECT_EQ(lines.size(), std::size_t(std::min(views, 10) + (views > 10)));
        if (views > 10) {
            EXPECT_NE(lines.back().find(std::to_string(views - 10) + " more error"), std::string::npos);
        }
    }
}

TEST(GitHub, PointsAtTheFileAndTheWaiversLine) {
    const std::string text = to_github(waived_run());
    EXPECT_NE(text.find("::error file=ci/waivers.toml,line=40,title=zproof%3A waiver expired expired::"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("::warning file=ci/waivers.toml,line=52,"), std::string::npos) << text;
    EXPECT_NE(text.find("::error file=models/room.glb,line=1,title=zproof%3A room/main defective::"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("zproof explain room 2 1"), std::string::npos);
}

TEST(GitHub, CannotBeWrittenToByASceneName) {
    Results r = many(1);
    r.views[0].scene = "x::\n::error ::owned\n::stop-commands::t";
    for (const std::string& line : lines_of(to_github(r)))
        EXPECT_TRUE(line.starts_with("::error title=")) << line;
    EXPECT_EQ(lines_of(to_github(r)).size(), 1u);
}

TEST(GitHub, SaysNothingWhereAllIsProven) {
    Results r = many(2);
    for (ViewResult& v : r.views) v.outcome = Outcome::proven, v.counts = {};
    EXPECT_EQ(to_github(r), "");
}

TEST(Markdown, HasARowPerViewAndTheWaivers) {
    const std::string text = to_markdown(waived_run());
    EXPECT_NE(text.find("| ✗ **defective** | room | main | 48 | 2 | 3 | 0 |"), std::string::npos) << text;
    EXPECT_NE(text.find("| expired | expired | room |"), std::string::npos) << text;
    EXPECT_NE(text.find("a &lt;sliver&gt; \\| of 50%, known"), std::string::npos) << text;
}

TEST(Markdown, CannotBeWrittenToByASceneName) {
    Results r = many(1);
    r.views[0].scene = "</td><script>|`![x](http://e)\n# big";
    const std::string text = to_markdown(r);
    EXPECT_EQ(text.find("<script>"), std::string::npos);
    EXPECT_EQ(text.find("![x]("), std::string::npos) << text;
    EXPECT_EQ(text.find("\n# big"), std::string::npos);
}

TEST(Markdown, StaysBelowTheLimitAndSaysWhatItLeftOut) {
    Results r = many(3);
    for (ViewResult& v : r.views) v.message = std::string(500'000, 'm');
    const std::string text = to_markdown(r);
    EXPECT_LE(text.size(), largest_summary);
    EXPECT_NE(text.find("left out"), std::string::npos);
    EXPECT_EQ(to_markdown(many(3)).find("left out"), std::string::npos);
}

TEST(Markdown, TellsWhatFailsHoweverManyViewsAreProven) {
    Results r = waived_run();
    const ViewResult proven = sample_results().views[0];
    r.views.insert(r.views.end(), 40'000, proven);
    const std::string few = to_markdown(waived_run()), text = to_markdown(r);
    EXPECT_LE(text.size(), largest_summary);
    EXPECT_EQ(occurrences(text, " left out, for a summary has its limits"), 1u);
    EXPECT_TRUE(text.ends_with(few.substr(few.find("\n### Waivers")))) << "waivers and stories";
}

TEST(Csv, HasARowPerViewAndClassAndAsManyFieldsInEach) {
    const auto lines = lines_of(to_csv(waived_run()));
    ASSERT_EQ(lines.size(), std::size_t(1 + pixel_class_count));
    for (const std::string& line : lines) EXPECT_EQ(fields_of(line), fields_of(lines[0])) << line;
    const std::string& hidden = lines[1 + std::size_t(PixelClass::hidden)];
    EXPECT_NE(hidden.find(",hidden,fails,3,1,"), std::string::npos) << hidden;
}

TEST(Csv, QuotesWhatANameMayHold) {
    const auto lines = lines_of(to_csv(sample_results()));
    for (const std::string& line : lines) EXPECT_EQ(fields_of(line), fields_of(lines[0])) << line;
    Results r = many(1);
    r.views[0].scene = "=SUM(\"a\",1)";
    EXPECT_TRUE(lines_of(to_csv(r))[1].starts_with("\"'=SUM(\"\"a\"\",1)\",v,suite,"));
}

}  // namespace zproof
