// The reports of a study, from results written by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/chart.h"
#include "reports/filters/crops.h"
#include "reports/filters/json.h"
#include "reports/filters/page.h"
#include "reports/filters/plots.h"
#include "reports/filters/tables.h"
#include "reports/page_scripts.h"

namespace zproof {
namespace {

using namespace study;

MethodScore method(const std::string& label, double rmse, double texels) {
    return {.label = label,
            .regions = {{"interior", 1000, 0.004, {rmse, -20 * std::log10(rmse)}},
                        {"horizon", 0, 0, {std::nan(""), std::nan("")}},
                        {"anisotropy 1", 10, 0, {rmse / 2, 0}},
                        {"anisotropy 1-2", 10, 0, {rmse, 0}},
                        {"angle 0-7.5", 10, 0, {rmse, 0}}},
            .cost = {.texels = texels,
                     .lines = 2.5,
                     .bytes_stored = 4096,
                     .build_ms = 1.25,
                     .ns_per_sample = 80,
                     .pixels = 1000},
            .flicker = {.rms = 0.03, .ratio = 1.5, .steps = 2},
            .file = "pictures/s-v/" + label + ".exr"};
}

StudyResults sample_study() {
    StudyResults r;
    r.version = "1", r.command = "zproof filters run <x>", r.compiler = "g++", r.truth = "B", r.threads = 2;
    r.metrics = {{.name = "rmse", .definition = "d", .source = "s"},
                 {.name = "psnr", .definition = "p", .source = "", .higher_is_better = true, .decimals = 2}};
    for (const char* region : {"interior", "horizon", "anisotropy 1", "anisotropy 1-2", "angle 0-7.5"})
        r.regions.push_back({region, "what it is"});
    for (const char* label : {"nearest", "dear_one", "best, & \"only\""})
        r.methods.push_back({label, "f", "l", "t", "s"});
    r.views.push_back({.scene = "scene",
                       .view = "view",
                       .reason = "because",
                       .width = 64,
                       .height = 32,
                       .textures = "8 x 8",
                       .methods = {method("nearest", 0.2, 1), method("dear_one", 0.205, 9),
                                   method("best, & \"only\"", 0.01, 4)},
                       .truth_file = "pictures/s-v/truth.exr",
                       .truth_seconds = 0.5});
    return r;
}

TEST(FiltersJson, ReadsBackWhatItWrote) {
    StudyResults results = sample_study();
    results.views[0].methods[1].regions[0].values[1] = std::numeric_limits<double>::infinity();
    const std::string text = filters_json(results);
    const StudyResults again = filters_from_json(text);
    EXPECT_EQ(filters_json(again), text);
    EXPECT_EQ(again.views[0].methods[1].regions[0].values[1], std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(again.views[0].methods[0].regions[1].values[0]));
}

TEST(FiltersJson, RefusesWhatItDidNotWrite) {
    std::string text = filters_json(sample_study());
    EXPECT_THROW(filters_from_json("{"), ReportError);
    EXPECT_THROW(filters_from_json("{}"), ReportError);
    text.replace(text.find("\"1.0\""), 5, "\"2.0\"");
    EXPECT_THROW(filters_from_json(text), ReportError);
}

TEST(FiltersCsv, HasARowPerValueAndQuotesNames) {
    const std::string csv = filters_csv(sample_study());
    const std::size_t head = csv.find(
        "\nscene,view,width,height,method,truth,region,pixels,metric,value,truth_half_width,resolved\n");
    ASSERT_NE(head, std::string::npos);
    EXPECT_NE(csv.find("scene,view,64,32,nearest,B,interior,1000,rmse,0.2,0.004,yes\n"), std::string::npos);
    EXPECT_NE(csv.find("scene,view,64,32,\"best, & \"\"only\"\"\",B,interior,1000,rmse,0.01,0.004,no\n"),
              std::string::npos);
    EXPECT_NE(csv.find("nearest,B,all,1000,bytes_stored,4096,,\n"), std::string::npos);
    EXPECT_EQ(csv.find("horizon"), std::string::npos);
    EXPECT_EQ(std::ranges::count(csv.substr(head + 1), '\n'), 1 + 3 * (4 * 2 + 5 + 2));
}

/// A line break in a command would end the comment.
TEST(FiltersCsv, BeginsWithItsProvenanceInComments) {
    StudyResults results = sample_study();
    results.command = "zproof filters\nrun";
    results.views[0].scene_sha256 = "c0ffee";
    const std::string csv = filters_csv(results), head = csv.substr(0, csv.find("\nscene,view"));
    for (const char* words : {"# zproof:commit", "# zproof:command zproof filters run\n",
                              "# zproof:processor", "# zproof:date", "# zproof:scene_sha256 c0ffee scene"})
        EXPECT_NE(head.find(words), std::string::npos) << words << "\n" << head;
    EXPECT_EQ(std::ranges::count(head, '\n') + 1, std::ranges::count(head, '#'));
}

/// 0.01 is not five times 0.004; nor are 0.2 and 0.205 so far apart.
TEST(FiltersTable, SaysWhatIsNotResolved) {
    const std::string table = filters_table(sample_study(), {"interior"});
    EXPECT_EQ(table.find("scene / view, 64 x 32, region 'interior' (1,000 pixels), GT-B\n"), 0u);
    EXPECT_NE(table.find("\n   1  best, & \"only\"  not resolved  not resolved"), std::string::npos) << table;
    EXPECT_NE(table.find("\n   2  nearest "), std::string::npos) << table;
    EXPECT_NE(table.find("0.2000         13.98"), std::string::npos) << table;
    EXPECT_NE(table.find("\n   2  dear_one "), std::string::npos) << table;
}

TEST(FiltersTable, ShowsCostsOfTheWholePictureBesideTheRegionsThatAreQuoted) {
    EXPECT_NE(filters_table(sample_study(), {"interior"}).find("flicker"), std::string::npos);
    const std::string part = filters_table(sample_study(), {"anisotropy 1"});
    EXPECT_NE(part.find("rmse"), std::string::npos);
    EXPECT_EQ(part.find("flicker"), std::string::npos) << part;
    EXPECT_EQ(part.find("4.0 KiB"), std::string::npos) << part;
}

TEST(FiltersLatex, EscapesWhatLatexWouldTakeForItself) {
    const std::string latex = filters_latex(sample_study(), {"interior"});
    EXPECT_NE(latex.find("best, \\& \"only\" & not resolved"), std::string::npos);
    EXPECT_NE(latex.find("dear\\_one"), std::string::npos);
    EXPECT_NE(latex.find("\\begin{tabular*}{\\textwidth}{@{\\extracolsep{\\fill}}rlrrrrrrrrr@{}}"),
              std::string::npos)
        << latex;
}

TEST(FiltersPage, HoldsWhatPeopleTypedAndNothingFromTheNetwork) {
    const StudyResults results = sample_study();
    const ViewFigures figures{.truth = {"The truth.", "data:image/png;base64,AA=="},
                              .crop = {1, 2, 3, 4},
                              .crops = {{"truth", "data:,"}},
                              .plots = filters_plots(results, results.views[0], {})};
    const std::string page = filters_page(results, {figures}, {});
    EXPECT_NE(page.find("zproof filters run &lt;x&gt;"), std::string::npos);
    EXPECT_NE(page.find("best, &amp; &quot;only&quot;"), std::string::npos);
    EXPECT_NE(page.find("not resolved"), std::string::npos);
    EXPECT_NE(page.find("Pixels 1,2,3,4"), std::string::npos);
    EXPECT_EQ(page.find("<script"), page.find(script_element(table_script()))) << "no script but ours";
    EXPECT_EQ(page.find("<script"), page.rfind("<script"));
    EXPECT_NE(page.find("<figure data-linked=\"1,2,3,4\">"), std::string::npos);
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(FiltersPlots, TheFrontIsWhatNobodyBeatsInBoth) {
    const std::vector<Plot> plots = filters_plots(sample_study(), {});
    ASSERT_EQ(plots.size(), 3u);
    EXPECT_EQ(plots[0].name, "pareto");
    EXPECT_EQ(plots[1].name, "anisotropy");
    EXPECT_EQ(plots[2].name, "angle");
    // Steps from nearest (1, 0.2) by its height to the best (4, 0.01): M, L, L, and never to dear_one.
    const std::string front = plots[0].svg.substr(plots[0].svg.find("<path d=\"M"));
    EXPECT_EQ(std::ranges::count(front.substr(0, front.find(" fill")), 'L'), 2);
}

/// Logarithmic from 1 to 100 with a twentieth of room at either end: 10 stands in the middle, whatever the
/// other axis does.
TEST(Chart, PlacesPointsByTheirScale) {
    Chart chart{
        .title = "t", .x = {"x", Scale::logarithmic, {}}, .y = {"y", Scale::linear, {}}, .series = {}};
    chart.series.push_back(
        {"a", {{1, 0}, {10, 1}, {100, 2}, {0, 1}, {std::nan(""), 1}}, SeriesStyle::marked, Joining::line});
    const std::string svg = chart_svg(chart);
    EXPECT_NE(svg.find("cx=\"311\" cy=\"199\""), std::string::npos) << svg;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    std::size_t circles = 0;
    for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1))
        ++circles;
    EXPECT_EQ(circles, 3u);
}

TEST(Crops, TheWorstPlaceIsWhereThePicturesErrTogether) {
    const Picture truth({90, 60});
    Picture a = truth, b = truth;
    a.at(5, 5) = {100, 0, 0};  // a single wild pixel does not win over many
    for (int y = 40; y < 50; ++y)
        for (int x = 60; x < 70; ++x) b.at(x, y) = {0, 0.2f, 0};
    ErrorTally tally{truth};
    tally.add(a);
    tally.add(b);
    const CropBox box = tally.worst(30);
    EXPECT_LE(box.x, 60);
    EXPECT_GE(box.x + box.width, 70);
    EXPECT_LE(box.y, 40);
    EXPECT_GE(box.y + box.height, 50);
}

TEST(Crops, EveryPixelIsASquare) {
    Picture picture({2, 1});
    picture.at(1, 0) = {1, 1, 1};
    const Plane<Rgb8> large = crop(picture, {0, 0, 2, 1}, 3);
    EXPECT_EQ(large.size(), (Resolution{6, 3}));
    EXPECT_EQ(large.at(2, 2), (Rgb8{0, 0, 0}));
    EXPECT_EQ(large.at(3, 0), (Rgb8{255, 255, 255}));
}

TEST(Crops, AreCutToThePicture) {
    EXPECT_EQ(in_words(*within({-5, 10, 20, 100}, {64, 32})), "0,10,15,22");
    EXPECT_FALSE(within({64, 0, 5, 5}, {64, 32}));
}

}  // namespace
}  // namespace zproof
