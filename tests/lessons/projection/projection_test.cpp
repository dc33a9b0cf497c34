// What the projection study's sections say of what was found.
#include <gtest/gtest.h>

#include <algorithm>

#include "lessons/projection/sections.h"
#include "lessons/projection/wireframe_svg.h"

namespace zproof {
namespace {

using namespace study::projection;

Wireframe two_lines() {
    return {{{0, 1, {0}}, {1, 2, {0}}},
            {{{{1, 2}, {7.25, 2}}, 0, Visibility::seen}, {{{1, 5}, {7, 5}}, 1, Visibility::hidden}}};
}

ProjectedView sample() {
    ProjectedView view;
    view.title = "room / door", view.stem = "room-door", view.size = {16, 8};
    view.accuracy.vertices = 3, view.accuracy.studied = 3, view.accuracy.on_canvas = 1;
    RouteScore score;
    score.route = "stages", score.numbers = "float32", score.other_pixel = 1;
    score.px.largest = 0.5;
    score.operations = {{"camera to screen", "near x", 0.1, 0.1, 0},
                        {"camera to screen", "divide by -z", 0.2, 0.3, 1}};
    view.accuracy.routes = {score};
    view.accuracy.rows = {{0, 4.0, 4.0, 2.0, {{0.5, 3.0}}}};
    view.accuracy.lost = {
        {0, "stages", "float32", 4, 4, 4, 4, 3, 4, 0.5, "camera to screen", "divide by -z"}};
    view.wireframe = two_lines();
    EdgeAgreement agreement;
    agreement.renderer = "zproof", agreement.boundaries = 9, agreement.largest_px = 0.001;
    agreement.farthest = {3, 2, 4, 2, 0.001, 0.002};
    view.agreements = {agreement};
    view.pictures = {{"POV-Ray", Plane<Rgb8>{{16, 8}}}};
    view.ids = Plane<Rgb8>{{16, 8}};
    view.absences = {"Nobody was asked."};
    return view;
}

const document::Table& table_of(const document::Section& section, const std::string& name) {
    for (const document::Item& item : section.items)
        if (document::name_of(item) == name) return std::get<document::Table>(item);
    throw std::runtime_error{name + ": no such table"};
}

TEST(ProjectionSections, NameTheOperationThatLosesPixels) {
    const document::Section section = vertex_section(sample());
    const document::Row row = table_of(section, "room-door-routes").rows.at(0);
    EXPECT_NE(std::ranges::find(row, document::Cell{"camera to screen: divide by -z"}), row.end());
    EXPECT_EQ(table_of(section, "room-door-lost").rows.size(), 1u);
    EXPECT_EQ(table_of(section, "room-door-operations").rows.size(), 2u);
}

TEST(ProjectionSections, OfNoVertexOnTheCanvasSaySo) {
    ProjectedView view = sample();
    view.accuracy.rows.clear();
    const document::Section section = vertex_section(view);
    EXPECT_EQ(section.items.size(), 1u);
    EXPECT_NE(section.paragraphs.back().find("No vertex"), std::string::npos);
}

TEST(ProjectionSections, ShowEveryPictureWithItsWireframeAndWhoIsAbsent) {
    const document::Section section = wireframe_section(sample());
    std::vector<std::string> names;
    for (const document::Item& item : section.items) names.push_back(document::name_of(item));
    for (const char* name : {"room-door-distances", "room-door-wireframe", "room-door-over-povray",
                             "room-door-farthest", "room-door-povray"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
    EXPECT_EQ(section.paragraphs.back(), "Nobody was asked.");
    document::Document whole{"t", "c", "v", {}, {lesson_section(), vertex_section(sample()), section}};
    EXPECT_NO_THROW(document::require_sound(whole));
}

TEST(ProjectionSections, TheIntroductionCountsLostPixels) {
    const auto words = projection_introduction({sample(), sample()});
    EXPECT_NE(words.at(1).find("Of 2 vertices"), std::string::npos) << words.at(1);
    EXPECT_NE(words.at(1).find("in float32, to 2 by stages (0.5 px); in float64, to none"), std::string::npos)
        << words.at(1);
}

TEST(LessonSection, CallsTheSlipsWhatTheyAre) {
    const document::Section section = lesson_section();
    std::string all;
    for (const document::Row& row : table_of(section, "lesson-routes").rows)
        all += std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]) + "\n";
    EXPECT_NE(all.find("stages is the projection"), std::string::npos) << all;
    EXPECT_NE(all.find("raster-from-screen is not the projection: first wrong stage: NDC to raster"),
              std::string::npos)
        << all;
}

TEST(WireframeSvg, DrawsHiddenLinesOnlyWhereNothingIsBeneath) {
    const Wireframe lines = two_lines();
    const Plane<Rgb8> picture{{16, 8}};
    const std::string plain = wireframe_svg({lines, {16, 8}, nullptr}),
                      over = wireframe_svg({lines, {16, 8}, &picture});
    EXPECT_NE(plain.find("M1 2L7.25 2"), std::string::npos) << plain;
    EXPECT_NE(plain.find("M1 5L7 5"), std::string::npos);
    EXPECT_NE(over.find("M1 2L7.25 2"), std::string::npos);
    EXPECT_EQ(over.find("M1 5L7 5"), std::string::npos);
    EXPECT_NE(over.find("data:image/png"), std::string::npos);
}

TEST(WireframeSvg, MagnifiesWithinThePictureAlsoAtItsCorner) {
    const Wireframe lines = two_lines();
    const Plane<Rgb8> picture{{16, 8}};
    const std::string corner = magnified_svg({lines, {16, 8}, &picture}, {15, 7, 15, 6, 0, 0}, 3);
    EXPECT_NE(corner.find("viewBox=\"10 2 6 6\""), std::string::npos) << corner.substr(0, 200);
    EXPECT_NE(magnified_svg({lines, {16, 8}, &picture}, {0, 0, 1, 0, 0, 0}, 30).find("viewBox=\"0 0 8 8\""),
              std::string::npos);
}

}  // namespace
}  // namespace zproof
