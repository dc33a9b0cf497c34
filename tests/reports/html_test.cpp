#include "reports/html.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fstream>
#include <sstream>

#include "reports/base64.h"
#include "reports/html_parts.h"
#include "reports/page_scripts.h"
#include "reports/planes/container.h"
#include "reports/planes/embedded.h"
#include "tests/reports/packed_page.h"
#include "tests/reports/sample.h"

namespace zproof {

namespace {

using nlohmann::json;

std::string page_without_pictures() { return to_html(sample_results(), "/nowhere"); }

void write_file(const std::filesystem::path& file, const std::string& content) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

TEST(Html, SetsStudiesBehindTheViewsAndNamesThemOnTop) {
    document::Document study;
    study.title = "Depths <and> gaps";
    study.command = "zproof study depth";
    study.sections = {{"Which format", {"By its gap."}, {}}};
    const std::vector<document::Document> studies{study, study};
    const std::string page = to_html(Results{}, ".", page_budget, studies);
    const std::size_t link = page.find("<a href=\"#study-2\">Depths &lt;and&gt; gaps</a>");
    EXPECT_LT(link, page.find("<article id=\"study-1\">"));
    EXPECT_LT(page.find("<article id=\"study-2\">"), page.find("<section id=\"study-2-1\">"));
    EXPECT_EQ(occurrences(page, "By its gap."), 2u);
    EXPECT_EQ(to_html(Results{}, ".").find("<article"), std::string::npos);
}

TEST(Html, BeginsWithItsForewordAndHasItsTitle) {
    document::Document foreword;
    foreword.title = "mine <keeps> all";
    foreword.sections = {{"Rasterization", {"As declared."}, {}}};
    const std::string page = to_html(Results{}, ".", page_budget, {}, &foreword);
    EXPECT_EQ(occurrences(page, "<title>zproof: mine &lt;keeps&gt; all</title>"), 1u);
    EXPECT_LT(page.find("<h1>mine &lt;keeps&gt; all</h1>"), page.find("As declared."));
    EXPECT_LT(page.find("As declared."), page.find("<h1>No view was judged, so nothing is proven.</h1>"));
    EXPECT_EQ(occurrences(page, "<main>"), 1u);
}

}  // namespace

TEST(Html, HoldsOneScriptThatItsPolicyAdmitsAndNoAddress) {
    const TestFolder run;
    write_sample_evidence(run.path() / "scenes/room-corner");
    const std::string page = to_html(sample_results(), run.path());
    EXPECT_EQ(occurrences(page, "<script>"), 1u);
    EXPECT_EQ(occurrences(page, "<script>") + occurrences(page, "<script type=\"application/"),
              occurrences(page, "<script"))
        << "all others are data";
    EXPECT_EQ(occurrences(page, "://"), 0u);
    EXPECT_EQ(occurrences(page, "url("), 0u);
    EXPECT_EQ(occurrences(page, "@import"), 0u);
    EXPECT_EQ(occurrences(page, "http"), 1u) << "http-equiv of the policy only";
    EXPECT_EQ(occurrences(page, "content=\"" + content_policy(viewer_script()) + "\""), 1u);
    EXPECT_EQ(occurrences(page, "default-src 'none'; script-src 'sha256-"), 1u);
    EXPECT_EQ(occurrences(page, "<img"), 6u);
    EXPECT_EQ(occurrences(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 4u);
    EXPECT_EQ(occurrences(page, "src=\"data:image/webp;base64,UklGR"), 1u) << "of its card";
    EXPECT_EQ(occurrences(page, "src=\"data:image/jpeg;base64,/9j/"), 1u) << "large";
}

TEST(Html, ANameCannotBreakOut) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, hostile_name), 0u);
    EXPECT_EQ(occurrences(page, "<img"), 0u);
    EXPECT_GE(occurrences(page, "&lt;/script&gt;&lt;img onerror=x&gt;"), 2u);
    EXPECT_EQ(occurrences(page, "covers &lt;it&gt;."), 1u);
}

TEST(Html, FailedViewsComeFirst) {
    const std::string page = page_without_pictures();
    const auto room = page.find("<h2>room"), refused = page.find("<h2>&lt;/script"),
               empty = page.find("<h2>empty"), meadow = page.find("<h2>meadow");
    ASSERT_NE(meadow, std::string::npos);
    EXPECT_LT(room, refused);
    EXPECT_LT(refused, empty);
    EXPECT_LT(empty, meadow);
    EXPECT_LT(page.find("href=\"#view-1\""), page.find("<h2>"));
    EXPECT_LT(page.find(">room <"), page.find(">meadow <"));
}

TEST(Html, SaysTheVerdictInWords) {
    EXPECT_EQ(
        occurrences(page_without_pictures(), "<h1>1 defective, 1 unreadable, 1 not judged, of 4 views.</h1>"),
        1u);
    Results results = sample_results();
    results.views.resize(1);
    EXPECT_EQ(occurrences(to_html(results, "/nowhere"), "<h1>The view is proven.</h1>"), 1u);
    results.views.clear();
    EXPECT_EQ(occurrences(to_html(results, "/nowhere"), "nothing is proven"), 2u) << "title and heading";
}

TEST(Html, TellsTheWorstPixels) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, "<code>zproof explain room 812 344</code>"), 2u) << "on top as well";
    EXPECT_EQ(occurrences(page, "Worst pixels"), 1u);
    EXPECT_EQ(occurrences(page, "title=\"0x3dcccccd\">0.1<"), 1u);
    EXPECT_EQ(occurrences(page, "3 lines were skipped."), 1u);
}

TEST(Html, BeginsWithTheAnswerAndACardOfEachView) {
    const std::string page = page_without_pictures();
    const std::size_t cause = page.find("<p class=\"cause\">"), cards = page.find("<div id=\"cards\""),
                      table = page.find("<details id=\"table\">"),
                      sections = page.find("<div id=\"sections\">");
    EXPECT_LT(cause, cards);
    EXPECT_LT(cards, table);
    EXPECT_LT(table, sections);
    EXPECT_EQ(occurrences(page, "<a class=\"card\""), sample_results().views.size());
    EXPECT_EQ(occurrences(page.substr(cards, table - cards), "not_judged"), 1u);
}

TEST(Html, APromiseIsALineOfWords) {
    EXPECT_EQ(promise_in_words(
                  R"({"kind": "raster", "subpixel_bits": 0, "matrices": 1, "third_weight": "edge_function",
                                   "least_area_px2": 0.0, "watertight": true, "clipped": false})"),
              "raster; matrices 1, subpixel bits 0, third weight edge function, watertight");
    EXPECT_EQ(promise_in_words(""), "") << "of older results";
}

TEST(Html, FoldsAllButTheFirstFailedSections) {
    Results results = sample_results();
    const ViewResult failed = results.views[1];
    ASSERT_EQ(failed.outcome, Outcome::defective);
    for (int i = 0; i < 4; ++i) results.views.push_back(failed);
    const std::string page = to_html(results, "/nowhere");
    EXPECT_EQ(occurrences(page, "<details open>"), 3u);
    EXPECT_EQ(occurrences(page, "<details><summary><h2>"), results.views.size() - 3 + 1) << "and the legend";
}

TEST(Html, ShowsDepthsAndEdgesOfBothAgainstTheirBounds) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, "aria-label=\"Depth error / bound, candidate, at most 0.93\""), 1u);
    EXPECT_EQ(occurrences(page, "aria-label=\"Edge displacement / bound, candidate, at most 0.875\""), 2u);
    EXPECT_EQ(occurrences(page, "embree: at most 0.25 times the bound."), 2u);
}

TEST(Html, TellsTheLikelyCauseAndWhatElseWasTested) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, "<h3>Likely cause</h3>"), 1u);
    EXPECT_EQ(occurrences(page, "<strong>a row is &lt;lost&gt;</strong>: 100% of 2 defects. "), 1u);
    EXPECT_EQ(occurrences(page,
                          "<strong>only 4 sub-pixel bits</strong>: 50.0% of 2 defects; but 3 of 1,000 "
                          "pixels that agree would be wrong. "),
              1u);
    Results results = sample_results();
    results.views[1].diagnosis->cause.reset();
    EXPECT_EQ(occurrences(to_html(results, "/nowhere"), "<h3>No single cause</h3>"), 1u);
}

TEST(Html, ShowsWhatTheOraclesAnsweredAndWhichAgree) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, "<strong>povray</strong>: 5 defects (5 hole)"), 1u);
    EXPECT_EQ(occurrences(page, "The &lt;oracle&gt; is wrong."), 1u);
    EXPECT_EQ(occurrences(page, "<strong>opengl</strong>: no &lt;device&gt;"), 1u);
    EXPECT_EQ(occurrences(page, "agree RMS 0.5, largest 1 (7 pixels)"), 1u);
    EXPECT_EQ(occurrences(page, "no picture: no &lt;canvas&gt;"), 1u);
    EXPECT_EQ(occurrences(page, "3.7 &lt;b&gt;"), 1u);
    EXPECT_EQ(occurrences(page, "not compared: no &lt;device&gt;"), 1u);
    EXPECT_EQ(occurrences(page, "All that were compared name the same triangle at 5 of 9 pixels."), 1u);
    EXPECT_EQ(occurrences(page,
                          "asked about 9 of 2,073,600 pixels, chosen by seed 1, fewer than usual: "
                          "&lt;many&gt; triangles"),
              1u);
}

TEST(Html, EveryClassIsInTheLegend) {
    const std::string page = page_without_pictures();
    for (int i = 0; i < pixel_class_count; ++i)
        EXPECT_GE(occurrences(page, "</i>" + std::string(name_of(PixelClass(i))) + "</span></dt>"), 1u);
}

/// Twenty failing views in folders of their own.
Results twenty_views() {
    Results results = sample_results();
    results.views.assign(20, results.views[1]);
    for (int i = 0; i < 20; ++i) results.views[std::size_t(i)].folder = "scenes/" + std::to_string(i);
    return results;
}

TEST(Html, StaysBelow25MegabytesWhateverThePicturesWeigh) {
    const TestFolder run;
    const Results results = twenty_views();
    for (const ViewResult& view : results.views) {
        write_file(run.path() / view.folder / "class-small.png", "tiny");
        write_file(run.path() / view.folder / "id-small.png", std::string(1'500'000, 'x'));
    }
    const std::string page = to_html(results, run.path());
    EXPECT_LT(page.size(), page_budget);
    EXPECT_GT(page.size(), 8'000'000u);
    EXPECT_EQ(occurrences(page, "data:image/png;base64,dGlueQ=="), 20u) << "small pictures still fit";
    EXPECT_EQ(occurrences(page, "Left out to keep this page small."), 16u);
    EXPECT_EQ(occurrences(page, "href=\"scenes/19/id.png\""), 1u);
}

/// The names of blocks that the page lacks of its view of that number, as the viewer reads them; null: none.
json left_out(const std::string& page, int view) {
    return embedded_planes(page, "view-" + std::to_string(view)).header.value("leftOut", json());
}

/// A block of each tier: classes, ids, depths.
planes::Container sample_planes(std::size_t weight) {
    const auto block = [&](const std::string& name) {
        return planes::Block{name, {{"coding", "bytes"}}, std::string(weight, name[0])};
    };
    return {{{"width", 8}}, {block("class"), block("candidate.id"), block("candidate.depth")}};
}

TEST(Html, StaysBelow25MegabytesWhateverThePlanesWeighAndSaysWhatIsLeftOut) {
    const TestFolder run;
    Results results = twenty_views();
    results.views[19].outcome = Outcome::proven;
    for (const ViewResult& view : results.views)
        write_file(run.path() / view.folder / "planes.zvp", planes::packed(sample_planes(700'000)));
    const std::string page = to_html(results, run.path());
    EXPECT_LT(page.size(), page_budget);
    EXPECT_GT(page.size(), 23'000'000u);
    EXPECT_EQ(occurrences(page, "<script type=\"application/zvp\""), 20u) << "classes of every view";
    EXPECT_EQ(occurrences(page, "34 planes (23.8 MB) of the views are left out"), 1u);
    EXPECT_EQ(left_out(page, 3), json()) << "failed views are served first";
    for (const int view : {4, 20})
        EXPECT_EQ(left_out(page, view), json({"candidate.id", "candidate.depth"})) << view;
}

TEST(Html, EmbedsPlanesAsTheyAreAndAnotherBudgetIsKept) {
    const TestFolder run;
    const Results results = sample_results();
    const std::string all = planes::packed(sample_planes(50'000));
    for (const std::size_t view : {0u, 1u})
        write_file(run.path() / results.views[view].folder / "planes.zvp", all);
    const std::string whole = to_html(results, run.path());
    EXPECT_EQ(occurrences(whole, base64(all)), 2u);
    EXPECT_EQ(occurrences(whole, "are left out"), 0u);
    const std::string tight = to_html(results, run.path(), whole.size() - 50'000);
    EXPECT_LT(tight.size(), whole.size() - 50'000);
    EXPECT_EQ(occurrences(tight, "1 plane (0.1 MB) of the views are left out"), 1u);
    EXPECT_EQ(occurrences(to_html(results, run.path(), 1000), "<script type=\"application/zvp\""), 0u);
}

TEST(Html, NeverEmbedsAPlaneWithoutTheOneThatItIsGuessedFrom) {
    const TestFolder run;
    const Results results = sample_results();
    planes::Container container = sample_planes(3'000);
    container.blocks[1].content.assign(400'000, 'x');
    container.blocks.push_back({"reference.id", {{"coding", "sparse"}, {"beside", "candidate.id"}}, "small"});
    write_file(run.path() / results.views[1].folder / "planes.zvp", planes::packed(container));
    const std::string page = to_html(results, run.path(), 300'000);
    EXPECT_EQ(left_out(page, 1), json({"candidate.id", "reference.id"}));
    EXPECT_EQ(left_out(to_html(results, run.path()), 1), json());
}

/// Blocks of a group end alike.
std::string last_letter(const std::string& block) { return block.substr(block.size() - 1); }

TEST(EmbeddedPlanes, PutsWhatThePageHasNoRoomForIntoScriptsBesideIt) {
    const TestFolder run;
    const planes::Container all = sample_planes(30'000);
    write_file(run.path() / "planes.zvp", planes::packed(all));
    const auto embedded = [&](std::size_t budget) {
        return planes::EmbeddedPlanes({{"view-1", run.path() / "planes.zvp"}},
                                      {1, [](const std::string&) { return 0; }, last_letter}, budget);
    };
    EXPECT_TRUE(embedded(1'000'000).scripts().empty());
    const planes::EmbeddedPlanes none = embedded(0);
    Page page;
    none.append_to(page);
    EXPECT_EQ(embedded_planes(text_of(page), "view-1").header.at("scripts"),
              json({{"planes/view-1-1.js", {"class"}},
                    {"planes/view-1-2.js", {"candidate.id"}},
                    {"planes/view-1-3.js", {"candidate.depth"}}}));
    ASSERT_EQ(none.scripts().size(), 3u);
    EXPECT_EQ(none.scripts()[1].name, "planes/view-1-2.js");
    EXPECT_EQ(text_of(none.scripts()[1].text), "zproofPlanes(\"planes/view-1-2.js\",\"" +
                                                   base64(planes::packed({json::object(), {all.blocks[1]}})) +
                                                   "\")\n");
    EXPECT_NE(none.omissions().find("3 planes (0.1 MB) of the views lie beside this page"),
              std::string::npos);
}

TEST(Html, DamagedPlanesAreNamed) {
    const TestFolder run;
    const Results results = sample_results();
    write_file(run.path() / results.views[1].folder / "planes.zvp", "damaged");
    EXPECT_THROW(to_html(results, run.path()), ReportError);
}

TEST(Html, WhatTheViewerReadsCannotEndItsElement) {
    const std::string page = page_without_pictures();
    EXPECT_EQ(occurrences(page, hostile_name), 0u);
    EXPECT_EQ(occurrences(packed_text(page, "facts-0"), hostile_name), 1u);
}

TEST(Html, HistogramHasABarPerFilledBinAndMarksTheBound) {
    BoundRecord record{.max_error_over_bound = 41.2};
    record.histogram[0] = 1'000'000;
    record.histogram[3] = 1;
    record.histogram[20] = 2;
    const std::string svg = histogram_svg("Depth error / bound", record);
    EXPECT_EQ(occurrences(svg, "<rect class=\"bar\""), 2u);
    EXPECT_EQ(occurrences(svg, "<rect class=\"over\""), 1u);
    EXPECT_EQ(occurrences(svg, "<title>0.15 to 0.20: 1 pixel</title>"), 1u);
    EXPECT_EQ(occurrences(svg, "class=\"bound\""), 1u);
    std::istringstream in(svg);
    boost::property_tree::ptree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(in, tree));
    EXPECT_EQ(occurrences(histogram_svg("", {}), "<rect"), 0u);
}

}  // namespace zproof
