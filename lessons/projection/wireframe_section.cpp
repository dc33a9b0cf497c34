#include <algorithm>

#include "lessons/projection/sections.h"
#include "lessons/projection/wireframe_svg.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study::projection;
using document::Drawing;
using document::Item;
using document::Table;

std::int64_t count_cell(std::uint64_t count) { return std::int64_t(count); }

Table distances_table(const ProjectedView& view) {
    Table table{
        .name = view.stem + "-distances",
        .caption = "Distance between wireframe and picture",
        .columns = {{"picture of", "", ""},
                    {"boundaries", "", "Pairs of neighbouring pixels that name different triangles."},
                    {"edge between", "",
                     "An edge of one of the two runs between the two centres: distance 0."},
                    {"edge beside", "",
                     "None does, but one passes as near as the renderer's declared displacement allows."},
                    {"by depth", "",
                     "Both triangles hold both centres: surfaces cross there, no edge is due."},
                    {"by a third", "", "The edge of a triangle between them that no centre sees."},
                    {"beyond", "", "Farther from any edge than the displacement allows."},
                    {"largest", "px",
                     "Distance from the line between two centres to the nearest edge, without 'by depth' "
                     "and 'by a third'."},
                    {"of what is allowed", "", "Largest distance / sqrt(2) eps, over the same."},
                    {"allowed there", "px", "sqrt(2) eps at the largest."},
                    {"at", "", "The pair's first pixel."}},
        .rows = {}};
    for (const EdgeAgreement& a : view.agreements)
        table.rows.push_back(
            {a.renderer, count_cell(a.boundaries), count_cell(a.crossed), count_cell(a.displaced),
             count_cell(a.by_depth), count_cell(a.by_others), count_cell(a.beyond), a.largest_px,
             a.largest_share, a.largest_px > 0 ? a.farthest.expected_px : 0.0,
             a.largest_px > 0 ? std::to_string(a.farthest.x) + ", " + std::to_string(a.farthest.y)
                              : std::string{"nowhere"}});
    return table;
}

/// Letters and digits of a renderer's name.
std::string stem_of(const std::string& renderer) {
    std::string stem;
    for (const char c : renderer) {
        if (c >= 'A' && c <= 'Z') stem += char(c - 'A' + 'a');
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) stem += c;
    }
    return stem;
}

Drawing closest_look(const ProjectedView& view, const EdgeAgreement& agreement) {
    const WireframeDrawing drawing{view.wireframe, view.size, &view.ids};
    return {view.stem + "-farthest",
            agreement.renderer +
                ", where picture and wireframe are farthest apart: " + rounded(agreement.largest_px) +
                " px between the marked pair of centres and the nearest edge. Pixels have their triangle's "
                "colour.",
            magnified_svg(drawing, agreement.farthest, 6)};
}

/// Sums up a route over views.
void add_to(std::vector<RouteScore>& scores, const RouteScore& score) {
    const auto same = std::ranges::find(scores, score.route, &RouteScore::route);
    if (same == scores.end()) {
        scores.push_back(score);
        return;
    }
    same->other_pixel += score.other_pixel;
    same->px.largest = std::max(same->px.largest, score.px.largest);
}

std::string in_words(const std::vector<RouteScore>& scores) {
    std::string words;
    for (const RouteScore& s : scores)
        words += (words.empty() ? "" : ", ") + grouped(s.other_pixel) + " by " + s.route + " (" +
                 rounded(s.px.largest) + " px)";
    return words.empty() ? "none" : words;
}

}  // namespace

document::Section wireframe_section(const ProjectedView& view) {
    document::Section section{view.title + ": wireframe", view.absences, {}};
    section.paragraphs.insert(section.paragraphs.begin(),
                              "Every edge of the scene, projected stage by stage in float64. Where two "
                              "neighbouring pixels name different "
                              "triangles, an edge should run between their centres.");
    const std::string remark = remark_on_lines(view.wireframe);
    section.items.push_back(distances_table(view));
    section.items.push_back(Drawing{view.stem + "-wireframe",
                                    "The wireframe; what is hidden is thin and grey. " + remark,
                                    wireframe_svg({view.wireframe, view.size, nullptr})});
    for (const ProjectedPicture& picture : view.pictures)
        section.items.push_back(
            Drawing{view.stem + "-over-" + stem_of(picture.renderer),
                    "The edges that are seen, over the picture of " + picture.renderer + ".",
                    wireframe_svg({view.wireframe, view.size, &picture.pixels})});
    if (!view.agreements.empty() && view.agreements.front().largest_px > 0)
        section.items.push_back(closest_look(view, view.agreements.front()));
    for (const ProjectedPicture& picture : view.pictures)
        section.items.push_back(document::picture_of(view.stem + "-" + stem_of(picture.renderer),
                                                     "The picture of " + picture.renderer + ".",
                                                     picture.pixels));
    return section;
}

std::vector<std::string> projection_introduction(const std::vector<ProjectedView>& views) {
    std::uint64_t vertices = 0;
    double largest_edge = 0;
    std::vector<RouteScore> single, twice;
    for (const ProjectedView& view : views) {
        vertices += view.accuracy.on_canvas;
        for (const RouteScore& s : view.accuracy.routes) add_to(s.numbers == "float32" ? single : twice, s);
        for (const EdgeAgreement& a : view.agreements)
            if (a.renderer == "zproof") largest_edge = std::max(largest_edge, a.largest_px);
    }
    return {
        "From world to raster space by every route of the lessons, in float32 and in float64, against exact "
        "rational arithmetic; and the wireframe against the pictures.",
        "Of " + grouped(vertices) + " vertices on the canvas another pixel is given, in float32, to " +
            in_words(single) + "; in float64, to " + in_words(twice) +
            ". The largest error stands behind each.",
        "Edges lie within " + rounded(largest_edge) + " px of the rasterized picture's boundaries."};
}

}  // namespace zproof
