#include "reports/fit/fit_report.h"

#include <algorithm>
#include <cmath>

#include "frame/precision_text.h"
#include "reports/fit/fit_words.h"

namespace zproof {
namespace {

using document::Cell;
using document::Section;
using document::Table;
using measure::LeftOut;
using measure::ViewFit;

std::string title_of(const FittedView& view) { return view.scene + " / " + view.view; }

Cell whole(std::uint64_t count) { return std::int64_t(count); }

Cell place(const PixelCoord& p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

document::Row row_of(const FittedView& view) {
    const ViewFit& fit = view.fit;
    const measure::DepthError& depth = fit.depth.error;
    return {title_of(view),
            fit.eps.px.low,
            fit.eps.found_px(),
            fit.eps.decided_by.empty() ? Cell{"-"} : place(fit.eps.decided_by.front()),
            depth.relative,
            depth.ulps,
            depth.of_range,
            whole(fit.seams),
            whole(fit.gaps),
            whole(fit.left_out.size()),
            std::string{fit.is_verified ? "verified" : "NOT VERIFIED"}};
}

Table figures(const std::vector<FittedView>& views) {
    Table table{.name = "views",
                .caption = "The least promise, view by view",
                .columns = {{"view", "", ""},
                            {"too small", "px", "This eps does not explain every pixel that is kept."},
                            {"eps", "px", "This eps does."},
                            {"decided at", "", "The first pixel that needs it."},
                            {"depth error", "", "As a share of the depth, beside what eps explains."},
                            {"in ULPs", "", "The same in float32 steps."},
                            {"of range", "", "The same as a share of far - near; 0 where far is infinite."},
                            {"seams", "px", "Pixels that show a seam of the scene."},
                            {"gaps", "px", "Pixels between triangles that share an edge."},
                            {"left out", "px", "Pixels that the promise does not explain."},
                            {"judge", "", "Is every other pixel admissible under the promise?"}},
                .rows = {}};
    for (const FittedView& view : views) table.rows.push_back(row_of(view));
    return table;
}

/// Over all views: how many pixels eps = 2^octave does not explain.
std::uint64_t unexplained(const std::vector<FittedView>& views, int octave) {
    std::uint64_t count = 0;
    for (const FittedView& v : views) count += v.fit.eps_px.above(octave);
    return count;
}

std::uint64_t of_depth(const std::vector<FittedView>& views, int octave) {
    std::uint64_t count = 0;
    for (const FittedView& v : views) count += v.fit.depth_relative.above(octave);
    return count;
}

Table curve_table(const std::vector<FittedView>& views) {
    Table table{.name = "curve",
                .caption = "Pixels that are not explained by an error of so much",
                .columns = {{"error", "", "Of place in px, of depth as a share of it."},
                            {"by eps", "px", "Pixels that are not explained by this eps."},
                            {"by depth error", "px", "Pixels that are not explained by this depth error."}},
                .rows = {}};
    for (int octave = measure::least_octave; octave <= measure::most_octave; ++octave) {
        table.rows.push_back({"2^" + std::to_string(octave), whole(unexplained(views, octave)),
                              whole(of_depth(views, octave))});
    }
    return table;
}

document::Plot curve_plot(const std::vector<FittedView>& views) {
    Series eps{.name = "eps, px", .points = {}, .joining = Joining::line},
        depth{.name = "depth error", .points = {}, .joining = Joining::line};
    for (int octave = measure::least_octave; octave <= measure::most_octave; ++octave) {
        eps.points.emplace_back(std::ldexp(1.0, octave), double(unexplained(views, octave)));
        depth.points.emplace_back(std::ldexp(1.0, octave), double(of_depth(views, octave)));
    }
    return {.name = "curve-plot",
            .caption = "Where the curve ends, every pixel is explained.",
            .chart = {.title = "Pixels not explained",
                      .x = {.title = "error", .scale = Scale::logarithmic, .names = {}},
                      .y = {.title = "pixels", .scale = Scale::logarithmic, .names = {}},
                      .series = {eps, depth}}};
}

Table trade_table(const std::vector<FittedView>& views) {
    Table table{
        .name = "trade",
        .caption = "The depth error that is left where more displacement is granted",
        .columns = {{"view", "", ""}, {"eps", "px", ""}, {"depth error", "", ""}, {"in ULPs", "", ""}},
        .rows = {}};
    for (const FittedView& view : views)
        for (const measure::DepthBeside& beside : view.fit.trade)
            table.rows.push_back({title_of(view), beside.eps_px, beside.error.relative, beside.error.ulps});
    return table;
}

Table left_out_table(const std::vector<FittedView>& views) {
    Table table{.name = "left-out",
                .caption = "Pixels that are left out",
                .columns = {{"view", "", ""},
                            {"x", "", "Column, 0 = left."},
                            {"y", "", "Row, 0 = top."},
                            {"id", "", "The triangle that is shown."},
                            {"depth", "", "The depth that is shown."},
                            {"why", "", ""}},
                .rows = {}};
    for (const FittedView& view : views)
        for (const LeftOut& l : view.fit.left_out)
            table.rows.push_back({title_of(view), std::int64_t(l.pixel.x), std::int64_t(l.pixel.y),
                                  std::int64_t(l.answer.primitive), double(l.answer.camera_depth),
                                  std::string{name_of(l.reason)}});
    return table;
}

}  // namespace

BoundedPrecision promise_of(const std::vector<FittedView>& views) {
    BoundedPrecision promise = views.front().fit.promise;
    for (const FittedView& view : views) promise = measure::cover(promise, view.fit.promise);
    return promise;
}

bool explains_all(const std::vector<FittedView>& views) {
    return std::ranges::all_of(
        views, [](const FittedView& v) { return v.fit.is_verified && v.fit.left_out.empty(); });
}

document::Document fit_document(const std::string& renderer, const std::vector<FittedView>& views) {
    document::Document document{.title = "The least promise of " + renderer,
                                .command = {},
                                .version = {},
                                .introduction = {},
                                .sections = {}};
    for (const FittedView& view : views)
        document.introduction.push_back(title_of(view) + ": " + fit_in_words(view.fit) + ".");
    document.introduction.push_back("Precision of all views, for --precision: " +
                                    precision_to_json(promise_of(views)));
    document.sections.push_back({"Views", {}, {figures(views), trade_table(views)}});
    document.sections.push_back({"Curve", {}, {curve_table(views), curve_plot(views)}});
    if (!explains_all(views)) document.sections.push_back({"Left out", {}, {left_out_table(views)}});
    return document;
}

}  // namespace zproof
