// A study's document: what every writer makes of it, and that it comes back whole.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "reports/page_scripts.h"
#include "reports/pages/folder.h"
#include "reports/pages/json.h"
#include "reports/pages/writers.h"
#include "tests/support/test_folder.h"

namespace zproof::document {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

Table errors() {
    return {.name = "errors",
            .caption = "Errors by route",
            .columns = {{"route", "", ""}, {"error", "px", "Largest distance."}, {"vertices", "", ""}},
            .rows = {{std::string{"stages, \"float\""}, 0.1 + 0.2, std::int64_t{12345}},
                     {std::string{"a<b"}, infinity, std::int64_t{-7}},
                     {std::string{"whole"}, 2.0, std::int64_t{0}}},
            .shown = 2};
}

Document sample_document() {
    Plane<Rgb8> pixels{{2, 1}};
    pixels.at(1, 0) = {255, 0, 0};
    const Plot plot{
        .name = "curve",
        .caption = "A curve.",
        .chart = {.title = "Curve",
                  .x = {"depth, m", Scale::logarithmic, {}},
                  .y = {"error", Scale::linear, {}},
                  .series = {{"float32", {{1, 2}, {10, 4}}, SeriesStyle::muted, Joining::steps}}}};
    Picture left = picture_of("left", "Left & right.", pixels);
    left.group = "pair";
    return {.title = "A study of <angles>",
            .command = "zproof study x",
            .version = "0.1.0",
            .introduction = {"What was asked."},
            .sections = {{"First", {"Words."}, {errors(), plot}},
                         {"Second", {}, {left, Drawing{"lines", "Lines.", "<svg/>"}}}}};
}

class DocumentFolder : public testing::Test {
  protected:
    const TestFolder own_folder_;
    const fs::path folder_ = own_folder_.path();
};

TEST_F(DocumentFolder, ComesBackAsItWas) {
    write_document(folder_, sample_document());
    EXPECT_EQ(read_document(folder_), sample_document());
}

TEST_F(DocumentFolder, HoldsAFileForEveryItem) {
    write_document(folder_, sample_document());
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator{folder_}) names.insert(entry.path().filename());
    EXPECT_EQ(names, (std::set<std::string>{"curve.svg", "errors.csv", "left.png", "lines.svg", "study.html",
                                            "study.json"}));
}

TEST_F(DocumentFolder, AMissingPictureIsNamed) {
    write_document(folder_, sample_document());
    fs::remove(folder_ / "left.png");
    try {
        read_document(folder_);
        FAIL() << "a picture is missing";
    } catch (const ReportError& e) {
        EXPECT_NE(std::string{e.what()}.find("left.png"), std::string::npos) << e.what();
    }
}

TEST(DocumentJson, NumbersKeepTheirKindAndTheirBits) {
    Document document = sample_document();
    std::get<Table>(document.sections[0].items[0]).rows[0][1] = std::nan("");
    document.sections[1].items.clear();
    const Document back = document_from_json(json_of(document), [](const std::string&) { return ""; });
    const Table& table = std::get<Table>(back.sections[0].items[0]);
    EXPECT_TRUE(std::isnan(std::get<double>(table.rows[0][1])));
    EXPECT_EQ(std::get<double>(table.rows[1][1]), infinity);
    EXPECT_EQ(std::get<double>(table.rows[2][1]), 2.0);  // not the whole number 2
    EXPECT_EQ(std::get<std::int64_t>(table.rows[0][2]), 12345);
}

TEST(DocumentJson, WhatIsNoneIsRefusedByItsPlace) {
    const auto nothing = [](const std::string&) { return std::string{}; };
    EXPECT_THROW(document_from_json("{}", nothing), ReportError);
    std::string text = json_of(sample_document());
    text.replace(text.find("\"1.0\""), 5, "\"2.0\"");
    EXPECT_THROW(document_from_json(text, nothing), ReportError);
    std::string other = json_of(sample_document());
    other.replace(other.find("\"chart\""), 7, "\"chant\"");
    EXPECT_THROW(document_from_json(other, nothing), ReportError);
}

TEST(DocumentCsv, HoldsEveryRowExactlyAndQuotesWhatMustBe) {
    EXPECT_EQ(csv_of(errors()),
              "route,\"error, px\",vertices\n\"stages, \"\"float\"\"\",0.30000000000000004,12345\n"
              "a<b,inf,-7\nwhole,2,0\n");
}

TEST(DocumentTerminal, ShowsTheFirstRowsInColumnsAndSaysHowManyThereAre) {
    EXPECT_EQ(terminal_text(sample_document()),
              "A study of <angles>\nWhat was asked.\n\nFirst\n\nErrors by route\n"
              "  route             error, px   vertices\n"
              "  stages, \"float\"         0.3     12,345\n"
              "  a<b                     inf         -7\n"
              "  (2 of 3 rows shown; all are in errors.csv)\n");
}

TEST(DocumentPage, EscapesShowsAndCarriesExactValues) {
    const std::string page = page_of(sample_document());
    EXPECT_NE(page.find("A study of &lt;angles&gt;"), std::string::npos);
    EXPECT_EQ(page.find("<angles>"), std::string::npos);
    EXPECT_NE(page.find("<table class=\"sortable\">"), std::string::npos);
    EXPECT_NE(page.find("data-value=\"0.30000000000000004\">0.3<"), std::string::npos);
    EXPECT_EQ(page.find("whole"), std::string::npos) << "the third row is not shown";
    EXPECT_NE(page.find("2 of 3 rows shown"), std::string::npos);
    EXPECT_EQ(page.find("<script"), page.find(script_element(table_script()))) << "no script but ours";
    EXPECT_EQ(page.find("<script"), page.rfind("<script"));
}

TEST(DocumentSound, MistakesOfOursAreNamed) {
    Document twice = sample_document();
    twice.sections[1].items.push_back(Drawing{"left", "", "<svg/>"});
    EXPECT_THROW(require_sound(twice), std::logic_error);
    Document short_row = sample_document();
    std::get<Table>(short_row.sections[0].items[0]).rows[1].pop_back();
    EXPECT_THROW(require_sound(short_row), std::logic_error);
    Document bad_name = sample_document();
    std::get<Drawing>(bad_name.sections[1].items[1]).name = "../lines";
    EXPECT_THROW(require_sound(bad_name), std::logic_error);
    Document reserved = sample_document();
    std::get<Drawing>(reserved.sections[1].items[1]).name = "study";
    EXPECT_THROW(require_sound(reserved), std::logic_error);
    EXPECT_NO_THROW(require_sound(sample_document()));
}

}  // namespace
}  // namespace zproof::document
