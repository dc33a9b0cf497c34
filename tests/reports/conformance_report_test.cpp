#include "reports/conformance_report.h"

#include <gtest/gtest.h>

namespace zproof {
namespace {

using measure::Conformity;

constexpr std::uint64_t pixels = 100;

ViewResult proven_view(const std::string& source) {
    ViewResult view;
    view.source = source;
    view.counts[std::size_t(PixelClass::agree)] = pixels;
    view.candidate_depth.max_error_over_bound = 0.5;
    return view;
}

Results proven_results() {
    Results results;
    results.renderers = {{.name = "mine", .version = "1", .precision = "{}"}};
    results.views = {proven_view("suite"), proven_view("random:soup:1:0")};
    return results;
}

MeasuredPromises measured(Conformity conformity) {
    return {{{"holes", "holes", measure::Bracket{0, 0}, "", "", "0", conformity}}, ""};
}

/// The row of the document that asks this; the verdict is its last cell.
std::vector<std::string> row(const document::Document& document, const std::string& asked) {
    for (const document::Section& section : document.sections)
        for (const document::Row& cells : std::get<document::Table>(section.items.at(0)).rows)
            if (std::get<std::string>(cells[0]) == asked) {
                std::vector<std::string> texts;
                for (const document::Cell& cell : cells) texts.push_back(std::get<std::string>(cell));
                return texts;
            }
    ADD_FAILURE() << asked;
    return {"", "", "", ""};
}

TEST(ConformanceReport, CountsWhatIsKept) {
    const auto document = conformance_document(proven_results(), measured(Conformity::as_declared));
    EXPECT_EQ(document.title, "mine keeps all 4 promises");
    EXPECT_EQ(row(document, "visibility, the suite")[2], "1 view, 100 pixels, 0 defects");
    EXPECT_EQ(row(document, "visibility, random scenes")[3], "kept");
    EXPECT_EQ(row(document, "depth")[2], "largest error / bound 0.5, 0 wrong_depth");
    EXPECT_EQ(row(document, "attributes")[3], "not asked");
    EXPECT_EQ(row(document, "texture filters")[3], "not asked");
    document::require_sound(document);
}

TEST(ConformanceReport, TellsTheSuitesDefectsFromThoseOfRandomScenes) {
    Results results = proven_results();
    ViewResult& random = results.views[1];
    random.outcome = Outcome::defective;
    random.counts[std::size_t(PixelClass::hole)] = 3;
    const auto document = conformance_document(results, measured(Conformity::as_declared));
    EXPECT_EQ(document.title, "mine breaks 1 of 4 promises");
    EXPECT_EQ(row(document, "visibility, the suite")[3], "kept");
    EXPECT_EQ(row(document, "visibility, random scenes")[2], "1 view, 103 pixels, 3 defects");
    EXPECT_EQ(row(document, "visibility, random scenes")[3], "NOT KEPT");
}

TEST(ConformanceReport, HoldsDepthAndAttributesByTheirOwnClass) {
    Results results = proven_results();
    ViewResult& view = results.views[0];
    view.attributes = {"bary", "uv"};
    view.outcome = Outcome::defective;
    view.counts[std::size_t(PixelClass::wrong_depth)] = 2;
    view.candidate_depth.max_error_over_bound = 1.25;
    auto document = conformance_document(results, measured(Conformity::as_declared));
    EXPECT_EQ(row(document, "depth")[2], "largest error / bound 1.25, 2 wrong_depth");
    EXPECT_EQ(row(document, "depth")[3], "NOT KEPT");
    EXPECT_EQ(row(document, "attributes")[2], "bary, uv, 1 view, 0 defects");
    EXPECT_EQ(row(document, "attributes")[3], "kept");
    view.counts[std::size_t(PixelClass::wrong_attribute)] = 1;
    document = conformance_document(results, measured(Conformity::as_declared));
    EXPECT_EQ(row(document, "attributes")[3], "NOT KEPT");
}

TEST(ConformanceReport, IsNotKeptWhereWhatWasMeasuredIsWorse) {
    EXPECT_EQ(conformance_document(proven_results(), measured(Conformity::worse)).title,
              "mine breaks 1 of 4 promises");
    EXPECT_EQ(row(conformance_document(proven_results(), measured(Conformity::undeclared)), "holes")[3],
              "not promised");
}

TEST(ConformanceReport, CountsTextureFilters) {
    MeasuredPromises promises = measured(Conformity::as_declared);
    TexturePromise trilinear{.filter = "trilinear", .promise = "trilinear-gl"};
    read_filter_check(trilinear, R"({"pictures": [{"pixels": 4096, "outside": 7, "slack": 1.5,
                                                   "outcome": "failed"}]})");
    promises.textures = {trilinear};
    auto document = conformance_document(proven_results(), promises);
    EXPECT_EQ(document.title, "mine breaks 1 of 5 promises");
    EXPECT_EQ(row(document, "trilinear filter")[2], "largest error / bound 1.5, 4,096 pixels, 7 outside");
    EXPECT_EQ(row(document, "trilinear filter")[3], "NOT KEPT");
    read_filter_check(promises.textures[0], R"({"pictures": [{"pixels": 4096, "outside": 0, "slack": 1,
                                                              "outcome": "passed"}]})");
    EXPECT_EQ(conformance_document(proven_results(), promises).title, "mine keeps all 5 promises");
    read_filter_check(promises.textures[0], R"({"pictures": [{"pixels": 4096, "outside": 0, "slack": 1,
                                                              "outcome": "nothing"}]})");
    document = conformance_document(proven_results(), promises);
    EXPECT_EQ(document.title, "mine: 1 of 5 promises not judged");
    EXPECT_EQ(row(document, "trilinear filter")[2], "nothing is proved");
}

TEST(ConformanceReport, SaysWhatWasNotJudged) {
    Results results = proven_results();
    results.views[0].outcome = Outcome::unreadable;
    const auto document = conformance_document(results, {{}, "no frame"});
    EXPECT_EQ(document.title, "mine: 2 of 4 promises not judged");
    EXPECT_EQ(row(document, "visibility, the suite")[3], "not judged");
    EXPECT_EQ(row(document, "grid, fill rule, watertightness, depth steps, clip")[2], "no frame");
}

}  // namespace
}  // namespace zproof
