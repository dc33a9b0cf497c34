#include <algorithm>
#include <cmath>

#include "frame/number_text.h"
#include "lessons/projection/sections.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study::projection;
using document::Plot;
using document::Table;

std::string label_of(const RouteScore& score) { return score.route + ", " + score.numbers; }

std::int64_t whole(std::uint64_t count) { return std::int64_t(count); }

Table places_table(const ProjectedView& view) {
    const ViewAccuracy& a = view.accuracy;
    return {.name = view.stem + "-places",
            .caption = "Where the vertices are",
            .columns = {{"vertices", "", "Of the scene."},
                        {"not finite", "", "A coordinate is infinite or NaN: no place, left out."},
                        {"studied", "", "Of the rest, evenly spread."},
                        {"on the canvas", "",
                         "Before the eye and in the picture, border included; the others of the "
                         "studied ones follow."},
                        {"beside it", "", ""},
                        {"behind the eye", "", "On or behind the plane of the eye: no image."},
                        {"on a pixel's border", "",
                         "On the canvas, with a whole number as a coordinate, exactly: the "
                         "slightest error may change the pixel."}},
            .rows = {{whole(a.vertices), whole(a.not_finite), whole(a.studied), whole(a.on_canvas),
                      whole(a.off_canvas), whole(a.behind_eye), whole(a.on_pixel_border)}}};
}

/// The operation that loses most pixels; empty where none is lost.
std::string worst_operation(const RouteScore& score) {
    const auto worst = std::ranges::max_element(score.operations, {}, &OperationScore::pixels_lost);
    if (worst == score.operations.end() || worst->pixels_lost == 0) return "";
    return worst->stage + ": " + worst->operation;
}

Table routes_table(const ProjectedView& view) {
    Table table{.name = view.stem + "-routes",
                .caption = "Error of each route, vertices on the canvas",
                .columns = {{"route", "", ""},
                            {"numbers", "", ""},
                            {"median", "px",
                             "Of the distance from the exact raster position, in x or y, whichever is more."},
                            {"99 %", "px", ""},
                            {"largest", "px", ""},
                            {"median", "ulp",
                             "In units of the last place of the exact coordinate; a coordinate near 0 has "
                             "a very small one."},
                            {"99 %", "ulp", ""},
                            {"largest", "ulp", ""},
                            {"other pixel", "",
                             "Vertices whose integer pixel (floor) is another than the exact one."},
                            {"lost most by", "",
                             "The operation after which exact arithmetic no longer leads to the pixel."},
                            {"other side", "", "Vertices called on the canvas that are not, or the reverse."},
                            {"no number", "", "Vertices that come out infinite or NaN."}},
                .rows = {}};
    for (const RouteScore& s : view.accuracy.routes)
        table.rows.push_back({s.route, s.numbers, s.px.median, s.px.p99, s.px.largest, s.ulp.median,
                              s.ulp.p99, s.ulp.largest, whole(s.other_pixel), worst_operation(s),
                              whole(s.other_side), whole(s.no_number)});
    return table;
}

Table operations_table(const ProjectedView& view) {
    Table table{
        .name = view.stem + "-operations",
        .caption = "What each operation costs",
        .columns = {{"route", "", ""},
                    {"numbers", "", ""},
                    {"stage", "", ""},
                    {"operation", "", ""},
                    {"mean", "px",
                     "By which it moves a vertex: all before in machine numbers, all after exact, with and "
                     "without it."},
                    {"largest", "px", ""},
                    {"pixels lost", "",
                     "Vertices that exact arithmetic could have saved before it, and not after."}},
        .rows = {},
        .shown = 64};
    for (const RouteScore& s : view.accuracy.routes)
        for (const OperationScore& o : s.operations)
            table.rows.push_back(
                {s.route, s.numbers, o.stage, o.operation, o.mean_px, o.largest_px, whole(o.pixels_lost)});
    return table;
}

Table lost_table(const ProjectedView& view) {
    Table table{.name = view.stem + "-lost",
                .caption = "Vertices that come to lie in another pixel, farthest off first",
                .columns = {{"vertex", "", "Index in the baked scene."},
                            {"route", "", ""},
                            {"numbers", "", ""},
                            {"x", "px", "Exact raster position."},
                            {"y", "px", ""},
                            {"pixel", "", ""},
                            {"instead of", "", "The exact one."},
                            {"error", "px", ""},
                            {"lost in", "", ""},
                            {"by", "", ""}},
                .rows = {},
                .shown = 12};
    for (const LostPixel& l : view.accuracy.lost)
        table.rows.push_back({std::int64_t(l.vertex), l.route, l.numbers, l.x, l.y,
                              shortest(l.got_x) + ", " + shortest(l.got_y),
                              std::to_string(l.pixel_x) + ", " + std::to_string(l.pixel_y), l.error_px,
                              l.stage, l.operation});
    return table;
}

Table vertices_table(const ProjectedView& view) {
    Table table{.name = view.stem + "-vertices",
                .caption = "Vertex by vertex",
                .columns = {{"vertex", "", ""},
                            {"x", "px", "Exact, cut to float64."},
                            {"y", "px", ""},
                            {"depth", "", "Camera depth."}},
                .rows = {},
                .shown = 8};
    for (const RouteScore& s : view.accuracy.routes) {
        table.columns.push_back({label_of(s), "px", ""});
        table.columns.push_back({label_of(s), "ulp", ""});
    }
    for (const VertexRow& row : view.accuracy.rows) {
        table.rows.push_back({std::int64_t(row.vertex), row.x, row.y, row.depth});
        for (const VertexError& error : row.errors) {
            table.rows.back().emplace_back(error.px);
            table.rows.back().emplace_back(error.ulp);
        }
    }
    return table;
}

/// Share of the vertices whose error is at most x, in some 40 steps.
Series distribution(const ProjectedView& view, std::size_t route) {
    std::vector<double> errors;
    for (const VertexRow& row : view.accuracy.rows)
        if (row.errors[route].px > 0) errors.push_back(row.errors[route].px);
    std::ranges::sort(errors);
    const RouteScore& score = view.accuracy.routes[route];
    Series series{label_of(score), {}, SeriesStyle::marked, Joining::line};
    const std::size_t step = std::max<std::size_t>(1, errors.size() / 40);
    const std::size_t exact = view.accuracy.rows.size() - errors.size();
    for (std::size_t i = 0; i < errors.size(); i += step)
        series.points.emplace_back(errors[i], double(exact + i + 1) / double(view.accuracy.rows.size()));
    return series;
}

Plot distribution_plot(const ProjectedView& view) {
    Plot plot{view.stem + "-distribution",
              "Share of the vertices on the canvas whose error is at most x. Vertices without any error are "
              "counted "
              "and not drawn.",
              {.title = "Errors of the routes",
               .x = {"error, px", Scale::logarithmic, {}},
               .y = {"share of vertices", Scale::linear, {}},
               .series = {}}};
    for (std::size_t r = 0; r < view.accuracy.routes.size(); ++r)
        plot.chart.series.push_back(distribution(view, r));
    return plot;
}

Plot depth_plot(const ProjectedView& view) {
    Plot plot{view.stem + "-depth",
              "The float32 routes' errors over camera depth; at most 300 vertices, evenly spread.",
              {.title = "Error and depth, float32",
               .x = {"camera depth", Scale::logarithmic, {}},
               .y = {"error, px", Scale::logarithmic, {}},
               .series = {}}};
    const std::size_t step = std::max<std::size_t>(1, view.accuracy.rows.size() / 300);
    for (std::size_t r = 0; r < view.accuracy.routes.size(); ++r) {
        if (view.accuracy.routes[r].numbers != "float32") continue;
        Series series{view.accuracy.routes[r].route, {}, SeriesStyle::marked, Joining::points};
        for (std::size_t i = 0; i < view.accuracy.rows.size(); i += step)
            series.points.emplace_back(view.accuracy.rows[i].depth, view.accuracy.rows[i].errors[r].px);
        plot.chart.series.push_back(std::move(series));
    }
    return plot;
}

}  // namespace

document::Section vertex_section(const ProjectedView& view) {
    document::Section section{view.title + ": vertices", {}, {}};
    section.paragraphs = {size_text(view.size.width, view.size.height) +
                          " pixels. The scene is baked: its vertices are in world space, and local to world "
                          "has been applied."};
    section.items = {places_table(view)};
    if (view.accuracy.rows.empty()) {
        section.paragraphs.push_back("No vertex lies on the canvas: there is nothing to compare.");
        return section;
    }
    section.items.insert(section.items.end(), {routes_table(view), distribution_plot(view), depth_plot(view),
                                               operations_table(view)});
    if (view.accuracy.lost.empty())
        section.paragraphs.push_back("No route puts any of these vertices into another pixel.");
    else
        section.items.push_back(lost_table(view));
    section.items.push_back(vertices_table(view));
    return section;
}

document::Section border_section(const study::projection::ViewAccuracy& accuracy) {
    ProjectedView view;
    view.title = "Pixel borders", view.stem = "pixel-borders", view.size = {640, 480};
    view.accuracy = accuracy;
    document::Section section = vertex_section(view);
    section.heading = "Vertices on the borders of pixels";
    section.paragraphs = {
        "The lessons' camera: a canvas from -1 to 1, near 0.1, 640 x 480 pixels. Every vertex lies on "
        "a crossing of pixel borders exactly, so that whatever errs towards the left or the top loses a "
        "pixel; the table of operations says which one did."};
    return section;
}

}  // namespace zproof
