#include "reports/results_diff.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/evidence.h"
#include "reports/findings_file.h"
#include "tests/reports/sample.h"

namespace zproof {

namespace {

constexpr auto hole = std::size_t(PixelClass::hole);

Results run_with(Outcome outcome, std::uint64_t holes, std::uint64_t edges = 0) {
    Results r;
    ViewResult& v = r.views.emplace_back();
    v.scene = "room";
    v.view = "main";
    v.outcome = outcome;
    v.counts[hole] = holes;
    v.counts[std::size_t(PixelClass::edge)] = edges;
    return r;
}

const Results proven = run_with(Outcome::proven, 0), two = run_with(Outcome::defective, 2),
              three = run_with(Outcome::defective, 3);

ViewChange change(const Results& before, const Results& after,
                  const std::vector<DefectPixel>* old_pixels = nullptr,
                  const std::vector<DefectPixel>* new_pixels = nullptr) {
    const auto list = [](const std::vector<DefectPixel>* p) {
        return p == nullptr ? DefectList{} : DefectList{*p};
    };
    return changes_between({before, {list(old_pixels)}}, {after, {list(new_pixels)}}).at(0);
}

}  // namespace

TEST(ResultsDiff, IsWorseWhereLessIsProven) {
    EXPECT_FALSE(is_worse(change(proven, proven)));
    EXPECT_TRUE(is_worse(change(proven, two)));
    EXPECT_FALSE(is_worse(change(two, proven)));
    EXPECT_TRUE(is_worse(change(two, three)));
    EXPECT_FALSE(is_worse(change(three, two)));
    EXPECT_TRUE(is_worse(change(proven, run_with(Outcome::unreadable, 0))));
    EXPECT_TRUE(is_worse(change(two, run_with(Outcome::not_judged, 0))));
    EXPECT_FALSE(is_worse(change(run_with(Outcome::unreadable, 0), two)));
}

TEST(ResultsDiff, DoesNotCountPassingPixelsAsWorse) {
    const Results with_edges = run_with(Outcome::proven, 0, 7);  // changes point into it
    const ViewChange c = change(proven, with_edges);
    EXPECT_FALSE(is_worse(c));
    EXPECT_TRUE(is_any_different(c));
    EXPECT_FALSE(is_any_different(change(proven, proven)));
}

TEST(ResultsDiff, CountsDefectsThatMovedAsNew) {
    const std::vector<DefectPixel> here{{1, 1, PixelClass::hole}, {5, 1, PixelClass::hole}};
    const std::vector<DefectPixel> there{{5, 1, PixelClass::hidden}, {0, 2, PixelClass::hole}};
    const ViewChange c = change(two, two, &here, &there);
    EXPECT_EQ(*c.appeared, (std::vector{there[1]}));
    EXPECT_EQ(*c.gone, (std::vector{here[0]}));
    EXPECT_TRUE(is_worse(c));
    EXPECT_FALSE(is_worse(change(two, two, &here, &here)));
    EXPECT_FALSE(is_worse(change(two, two)));
}

TEST(ResultsDiff, CountsNewAndFixedDefectsInWords) {
    const std::vector<DefectPixel> one{{1, 1, PixelClass::hole}},
        others{{2, 1, PixelClass::hole}, {3, 1, PixelClass::hole}};
    const std::string table = differences_table(two, two, {change(two, two, &one, &others)});
    EXPECT_NE(table.find("    2 new defects: (2, 1) hole"), std::string::npos) << table;
    EXPECT_NE(table.find("    1 fixed defect: (1, 1) hole\n"), std::string::npos) << table;
}

TEST(ResultsDiff, NamesEmbreeOnce) {
    Results before = two, after = two;
    before.embree = "Embree 3.13.5", after.embree = "Embree 4.3.3";
    before.renderers = {{"embree", before.embree, "{}"}, {"povray", "POV-Ray 3.7", "{}"}};
    const std::string table = differences_table(before, after, {});
    EXPECT_NE(table.find("before: zproof , Embree 3.13.5; povray POV-Ray 3.7\n"), std::string::npos) << table;
}

TEST(RendererFacts, AreTitledWithoutSayingTheNameTwice) {
    EXPECT_EQ(title_of({"embree", "Embree 3.13.5 (AVX2)", ""}), "Embree 3.13.5 (AVX2)");
    EXPECT_EQ(title_of({"povray", "POV-Ray 3.7", ""}), "povray POV-Ray 3.7");
    EXPECT_EQ(title_of({"embree", "", ""}), "embree");
    EXPECT_EQ(title_of({"embree", "Emb", ""}), "embree Emb");
}

TEST(ResultsDiff, TakesWaivedDefectsForPassing) {
    Results waived = three;
    waived.views[0].waived[hole] = 3;
    waived.views[0].outcome = Outcome::proven;
    EXPECT_FALSE(is_worse(change(proven, waived)));
    EXPECT_FALSE(is_worse(change(two, waived)));
    EXPECT_TRUE(is_worse(change(waived, three)));
}

TEST(ResultsDiff, NamesViewsThatAreNewOrGone) {
    Results other = two;
    other.views[0].view = "back";
    const auto changes = changes_between({proven, {std::nullopt}}, {other, {std::nullopt}});
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].after, nullptr);
    EXPECT_EQ(changes[1].before, nullptr);
    EXPECT_TRUE(is_worse(changes[0]));
    EXPECT_TRUE(is_worse(changes[1]));
    const std::string table = differences_table(proven, other, changes);
    EXPECT_NE(table.find("room/main  proven -> gone"), std::string::npos) << table;
    EXPECT_NE(table.find("room/back  new -> defective"), std::string::npos) << table;
    EXPECT_NE(table.find("0 the same, 0 changed and not worse, 2 worse"), std::string::npos) << table;
    const auto json = nlohmann::json::parse(differences_json(proven, other, changes));
    EXPECT_EQ(json.at("worse"), true);
    EXPECT_TRUE(json.at("views")[0].at("after").is_null());
}

TEST(FindingsFile, ReadsBackWhatTheEvidenceHas) {
    const Verdict verdict = sample_view().verdict;
    std::ostringstream out;
    write_findings(out, verdict);
    const std::vector<Finding> back = findings_from_csv(out.str(), "f.csv");
    ASSERT_EQ(back.size(), verdict.findings.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_EQ(back[i].x, verdict.findings[i].x);
        EXPECT_EQ(back[i].verdict, verdict.findings[i].verdict);
        EXPECT_EQ(back[i].candidate.primitive, verdict.findings[i].candidate.primitive);
        EXPECT_EQ(back[i].reference.primitive, verdict.findings[i].reference.primitive);
    }
}

TEST(FindingsFile, NamesTheLineThatIsNone) {
    for (const char* line :
         {"1,2", "1,2,holy,none,3", "x,2,hole,none,3", "1,2,hole,none,3x", "1,2,hole,-1,3"})
        try {
            findings_from_csv(std::string{"x,y\n1,2,hole,none,3\n"} + line + "\n", "f.csv");
            FAIL() << line;
        } catch (const ReportError& e) {
            EXPECT_EQ(std::string{e.what()}.find("f.csv:3: "), 0u) << e.what();
        }
}

}  // namespace zproof
