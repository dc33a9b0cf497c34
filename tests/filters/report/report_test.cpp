// The reports of a study, from results written by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "filters/report/crops.h"
#include "filters/report/evidence_planes.h"
#include "filters/report/inspection_words.h"
#include "filters/report/json.h"
#include "filters/report/page.h"
#include "filters/report/plots.h"
#include "filters/report/tables.h"
#include "reports/page_scripts.h"
#include "reports/pages/chart.h"
#include "tests/reports/plane_decoder.h"

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
    const std::string page = text_of(filters_page(results, {{figures}, {}}, "no folder").page);
    EXPECT_NE(page.find("zproof filters run &lt;x&gt;"), std::string::npos);
    EXPECT_NE(page.find("best, &amp; &quot;only&quot;"), std::string::npos);
    EXPECT_NE(page.find("not resolved"), std::string::npos);
    EXPECT_NE(page.find("Pixels 1,2,3,4"), std::string::npos);
    EXPECT_NE(page.find(script_element(viewer_script())), std::string::npos);
    EXPECT_EQ(page.find("<script>"), page.rfind("<script>")) << "no script but ours";
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

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(FiltersPlots, SayHowManyPixelsAPlaceStandsForAndDrawFewWeakly) {
    StudyResults results = sample_study();
    for (MethodScore& method : results.views[0].methods) method.regions[2].pixels = 20'000;
    const std::string svg = filters_plots(results, {})[1].svg;
    EXPECT_NE(svg.find(">n 20,000</text>"), std::string::npos);
    EXPECT_NE(svg.find(">n 10</text>"), std::string::npos);
    EXPECT_EQ(count_of(svg, "fill-opacity=\"0.36\""), 3u) << "one place, three methods: " << svg;
}

TEST(FiltersPlots, NameTheOthersOnlyWhereNamesFit) {
    StudyResults results = sample_study();
    const auto names = [&] { return count_of(filters_plots(results, {})[0].svg, ">dear_one</text>"); };
    EXPECT_EQ(names(), 1u);
    for (int i = 0; i < 44; ++i) {
        const std::string label = "more-" + std::to_string(i);
        results.methods.push_back({label, "f", "l", "t", "s"});
        results.views[0].methods.push_back(method(label, 0.3, 2));
    }
    EXPECT_EQ(names(), 0u);
}

TEST(Chart, ThousandsAreWrittenOut) {
    Chart chart{
        .title = "t", .x = {"x", Scale::logarithmic, {}}, .y = {"y", Scale::linear, {}}, .series = {}};
    chart.series.push_back({"a", {{10, 1}, {20'000, 2}}, SeriesStyle::marked, Joining::line});
    const std::string svg = chart_svg(chart);
    EXPECT_NE(svg.find(">1,000</text>"), std::string::npos) << svg;
    EXPECT_NE(svg.find(">10,000</text>"), std::string::npos);
    EXPECT_EQ(svg.find("e+0"), std::string::npos);
}

TEST(Chart, ASeriesIsOneThingToAPage) {
    Chart chart;
    chart.series.push_back({"a<b", {{1, 1}, {2, 2}}, SeriesStyle::marked, Joining::line});
    EXPECT_EQ(count_of(chart_svg(chart), "<g class=\"series\" data-series=\"a&lt;b\">"), 2u)
        << "marks and name";
}

TEST(FiltersPage, TheFirstClickOnAMetricPutsTheBestFirst) {
    const StudyResults results = sample_study();
    const std::string page = text_of(filters_page(results, {{ViewFigures{}}, {}}, "no folder").page);
    EXPECT_NE(page.find("data-first=\"ascending\">rmse</th>"), std::string::npos);
    EXPECT_NE(page.find("data-first=\"descending\">psnr</th>"), std::string::npos);
}

/// A picture of three pixels: exact, off in red, off in all.
study::ViewEvidence small_evidence() {
    Picture truth({3, 1}, {0.25f, 0.5f, 0.75f});
    study::ViewEvidence known{truth, Plane<double>({3, 1}, 0.125), Plane<Patch>({3, 1}), {}};
    known.patches.at(1, 0) = {
        .major = 4, .minor = 2, .lod = 2, .centre = {7, 9}, .per_x = {4, 0}, .per_y = {0, 2}};
    known.regions.push_back({"all", Plane<std::uint8_t>({3, 1}, 1), 3});
    known.regions.push_back({"interior", Plane<std::uint8_t>({3, 1}), 1});
    known.regions[1].mask.at(2, 0) = 1;
    return known;
}

std::string content_of(const planes::Container& container, const std::string& name) {
    for (const planes::Block& block : container.blocks)
        if (block.name == name) return block.content;
    ADD_FAILURE() << "no block " << name;
    return {};
}

float as_float(std::uint32_t bits) { return std::bit_cast<float>(bits); }

TEST(EvidencePlanes, HoldFloatsBitByBit) {
    const study::ViewEvidence known = small_evidence();
    EvidencePlanes writer(known);
    Picture picture = known.truth;
    picture.at(1, 0) = {0.3f, 0.5f, 0.75f};
    picture.at(2, 0) = {-1e-30f, 1e30f, 2};
    writer.add_picture("m", picture);
    Plane<double> flip({3, 1});
    flip.at(1, 0) = 0.5, flip.at(2, 0) = 7;
    writer.add_flip("m", flip);
    const planes::Container made =
        std::move(writer).container({"s", "v", "N", "zproof filters explain s"}, {});
    const auto red = planes::decode(content_of(made, "truth.r"), 3, 3, planes::Prediction::planar);
    EXPECT_EQ(as_float(red[2]), 0.25f);
    const auto off = planes::decode(content_of(made, "method.m.r"), red);
    EXPECT_EQ(as_float(off[0]), 0.25f);
    EXPECT_EQ(as_float(off[1]), 0.3f);
    EXPECT_EQ(as_float(off[2]), -1e-30f);
    const auto bits = planes::decode(content_of(made, "region"), 3, 3, planes::Prediction::left);
    EXPECT_EQ(bits, (std::vector<std::uint32_t>{1, 1, 3}));
    const auto lod = planes::decode(content_of(made, "lod"), 3, 3, planes::Prediction::planar);
    EXPECT_EQ(as_float(lod[1]), 2);
    const std::string bytes = planes::inflated(content_of(made, "method.m.flip"), 3);
    EXPECT_EQ(bytes, (std::string{'\0', '\x80', '\xff'}));
    EXPECT_EQ(made.header.at("methods"), nlohmann::json({"m"}));
    EXPECT_EQ(made.header.at("regions").at(1).at("pixels"), 1);
}

TEST(EvidencePlanes, HoldWhatAClaimPermits) {
    const study::ViewEvidence known = small_evidence();
    EvidencePlanes writer(known);
    const Picture& picture = known.truth;
    PermittedInterval permitted{picture, picture};
    permitted.least.at(1, 0).g = 0.1f, permitted.greatest.at(2, 0).b = 0.9f;
    writer.add_picture("m", picture);
    writer.add_claim({"m", "ewa-true", "gpu", picture, permitted});
    const planes::Container made =
        std::move(writer).container({"s", "v", "N", "zproof filters explain s"}, {});
    std::vector<std::uint32_t> green, blue;
    for (const LinearRgb& colour : picture.pixels()) {
        green.push_back(std::bit_cast<std::uint32_t>(colour.g));
        blue.push_back(std::bit_cast<std::uint32_t>(colour.b));
    }
    EXPECT_EQ(as_float(planes::decode(content_of(made, "claim.m.least.g"), green)[1]), 0.1f);
    EXPECT_EQ(planes::decode(content_of(made, "claim.m.greatest.g"), green), green);
    EXPECT_EQ(as_float(planes::decode(content_of(made, "claim.m.greatest.b"), blue)[2]), 0.9f);
    EXPECT_EQ(made.header.at("claims"),
              nlohmann::json({{"m", {{"method", "ewa-true"}, {"promise", "gpu"}}}}));
}

PixelInspection told(std::vector<WeightFinding> findings) {
    PixelInspection one;
    one.x = 9, one.y = 99, one.label = "ewa", one.texture_width = 8, one.texture_height = 8;
    one.ellipse = {.major = 8.5, .minor = 2.1, .major_direction = {1, 0}};
    one.reading.emplace();
    one.reading->images = {
        {.image = 3, .width = 1, .height = 1, .taps = 4, .weight = 0.75, .level = {{3, 3}}},
        {.image = 4, .width = 1, .height = 1, .taps = 4, .weight = 0.25, .level = {{4, 4}}}};
    one.exact.emplace();
    one.findings = std::move(findings);
    return one;
}

TEST(InspectionWords, TellTheLevelAndTheNumbersBehindTheWord) {
    EXPECT_EQ(why(told({{WeightFault::blur, false, 3.25, 0.9}})),
              "reads level 3.25 for a minor axis of 2.1 texels: blur along the minor axis by 111.9 % of it "
              "(the weights spread "
              "over 3.25 texels, the pixel's over 0.9)");
    EXPECT_NE(why(told({{WeightFault::alias, true, 1, 4}})).find("alias along the major axis"),
              std::string::npos);
    EXPECT_NE(why(told({{WeightFault::shift, true, 0.5, 0}})).find("centroid lies 0.5 texels beside"),
              std::string::npos);
    const std::string both =
        why(told({{WeightFault::blur, true, 4.01, 4}, {WeightFault::shift, false, 0.5, 0}}));
    EXPECT_LT(both.find("shift along the minor axis by 23.81 %"),
              both.find("blur along the major axis by 0.1176 %"));
    EXPECT_NE(why(told({})).find("none of blur, alias and shift"), std::string::npos);
}

TEST(InspectionWords, GuessNothingWhereANumberIsMissing) {
    PixelInspection one = told({});
    one.exact->wraps = true;
    EXPECT_NE(why(one).find("not told, since the pixel covers more than the texture"), std::string::npos);
    one.exact.reset();
    EXPECT_NE(why(one).find("not told, since the truth is sampled"), std::string::npos);
    one.reading.reset();
    EXPECT_EQ(why(one), "not told: nobody records what this sampler reads");
    EXPECT_EQ(in_a_line(one), "pixel 9,99, ewa: not told: nobody records what this sampler reads\n");
}

ClaimedPixel claimed(float green) {
    return {.method = "bilinear",
            .promise = "gpu",
            .value = {0.5f, green, 0.1f},
            .permitted = {{0.25f, 0.25f, 0.1f}, {0.75f, 0.75f, 0.1f}}};
}

TEST(ClaimWords, TellWhatIsPermittedToTheLastFloat) {
    EXPECT_EQ(in_words(claimed(0.75f)),
              "the picture is within what bilinear permits, promising gpu\n"
              "  red         0.5, permitted 0.25 to 0.75: within\n"
              "  green       0.75, permitted 0.25 to 0.75: within\n"
              "  blue        0.100000001, permitted 0.100000001 to 0.100000001: within\n");
    const ClaimedPixel beyond = claimed(std::nextafter(0.75f, 1.0f));
    EXPECT_TRUE(is_outside(beyond));
    EXPECT_NE(
        in_words(beyond).find("  green       0.75000006, permitted 0.25 to 0.75: outside by 5.96e-08\n"),
        std::string::npos)
        << in_words(beyond);
    EXPECT_EQ(in_a_line(claimed(1.0f)),
              "the picture is outside by 0.25 of what bilinear permits, promising gpu\n");
}

TEST(ClaimWords, SayWhereNoFloatIsPermittedAndWhereTheValueIsNoNumber) {
    ClaimedPixel one = claimed(0.5f);
    one.promise = "", one.permitted.least.g = 0.8f;
    EXPECT_NE(in_words(one).find("green       0.5, permitted no float32: outside by inf\n"),
              std::string::npos)
        << in_words(one);
    EXPECT_EQ(in_a_line(one), "the picture is outside by inf of what bilinear permits\n");
    EXPECT_TRUE(is_outside(claimed(std::nanf(""))));
}

TEST(Crops, ErrorsAreShownByTheirLogarithm) {
    const Picture truth({3, 1});
    Picture picture = truth;
    picture.at(1, 0) = {0, 1.0f / 32, 0};
    picture.at(2, 0) = {1, 0, 0};
    const Plane<Rgb8> errors = error_crop(picture, truth, {0, 0, 3, 1}, 2);
    EXPECT_EQ(errors.size(), (Resolution{6, 2}));
    EXPECT_EQ(errors.at(1, 1), (Rgb8{68, 1, 84}));
    EXPECT_EQ(errors.at(3, 0), (Rgb8{33, 145, 140}));
    EXPECT_EQ(errors.at(5, 1), (Rgb8{253, 231, 37}));
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
