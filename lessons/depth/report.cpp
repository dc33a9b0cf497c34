#include "lessons/depth/report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "frame/joined.h"
#include "reports/pages/error_colours.h"
#include "reports/wording.h"

namespace zproof {
namespace {

using namespace study::depth;
using document::Item;
using document::Row;
using document::Section;
using document::Table;

/// Is there room for the format in a chart? In [-1, 1] whole numbers hold what they hold in [0, 1].
bool is_charted(const Format& format) {
    return format.range == NdcRange::zero_to_one || format.store == Store::float32;
}

std::string power_of_ten(double value) { return "1e" + std::to_string(int(std::lround(std::log10(value)))); }

Table choice_table(const std::vector<Choice>& choices) {
    Table table{.name = "choice",
                .caption =
                    "The formats of the fewest bits that keep a gap in order everywhere between near and "
                    "far. Gaps as shares of far; 1/z interpolated",
                .columns = {{"far / near", "", ""}},
                .rows = {}};
    for (const Choice& choice : choices) {
        if (table.rows.empty() || std::get<std::string>(table.rows.back()[0]) != power_of_ten(choice.ratio))
            table.rows.emplace_back().emplace_back(power_of_ten(choice.ratio));
        table.rows.back().emplace_back(choice.names.empty() ? "none" : joined(choice.names));
        const std::string gap = "gap " + shortest(choice.gap_of_far);
        if (table.rows.size() == 1) table.columns.push_back({gap, "of far", ""});
    }
    return table;
}

Table question_table(const DepthQuestion& question) {
    Table table{.name = "formats",
                .caption = "The smallest gap that each format keeps in order everywhere between near " +
                           rounded(question.planes.near) + " and far " + rounded(question.planes.far),
                .columns = {{"format", "", ""},
                            {"bits", "", ""},
                            {"worst gap", "scene units", "Predicted from the arithmetic, not fitted."},
                            {"of far", "", ""},
                            {"holds", "", "Is that no more than the gap asked for?"},
                            {"what is stored", "", ""}},
                .rows = {}};
    for (const WorstGap& one : worst_gaps(question.planes, question.gap))
        table.rows.push_back({std::string{one.format.name}, std::int64_t{bits_of(one.format.store)}, one.gap,
                              one.gap / question.planes.far,
                              std::string{question.gap == 0 ? "-"
                                          : one.holds       ? "yes"
                                                            : "no"},
                              definition_of(one.format)});
    return table;
}

/// A chart with the predicted gap as a line and measured ones as grey points beside it.
Chart gap_chart(const std::vector<GapCurve>& curves, double ratio) {
    Chart chart{.title = "Smallest gap kept in order, far / near = " + power_of_ten(ratio),
                .x = {.title = "distance / near", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "gap / near", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    for (const GapCurve& curve : curves) {
        if (curve.planes.far != ratio || !is_charted(curve.format)) continue;
        Series predicted{.name = curve.format.name, .points = {}},
            measured{.name = std::string{curve.format.name} + " measured",
                     .points = {},
                     .style = SeriesStyle::quiet,
                     .joining = Joining::points};
        for (const GapAt& at : curve.points) {
            predicted.points.push_back({at.depth, at.predicted});
            measured.points.push_back({at.depth, at.measured});
        }
        chart.series.push_back(std::move(predicted));
        chart.series.push_back(std::move(measured));
    }
    return chart;
}

Chart ways_chart(const std::vector<GapCurve>& curves) {
    Chart chart{.title = "The same by interpolation, far / near = 1e4",
                .x = {.title = "distance / near", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "gap / near", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    for (const GapCurve& curve : curves) {
        Series predicted{.name = std::string{curve.format.name} + ", " + name_of(curve.interpolation),
                         .points = {}};
        Series measured{.name = predicted.name + " measured",
                        .points = {},
                        .style = SeriesStyle::quiet,
                        .joining = Joining::points};
        for (const GapAt& at : curve.points) {
            predicted.points.push_back({at.depth, at.predicted});
            measured.points.push_back({at.depth, at.measured});
        }
        chart.series.push_back(std::move(predicted));
        chart.series.push_back(std::move(measured));
    }
    return chart;
}

Table gap_table(const std::vector<GapCurve>& curves, const std::string& name) {
    Table table{.name = name,
                .caption = "Every distance tried; near is 1",
                .columns = {{"far / near", "", ""},
                            {"format", "", ""},
                            {"interpolation", "", ""},
                            {"distance", "near", ""},
                            {"predicted", "near", ""},
                            {"measured", "near", "Every larger gap tried is in order at every pixel."}},
                .rows = {},
                .shown = 0};
    for (const GapCurve& curve : curves)
        for (const GapAt& at : curve.points)
            table.rows.push_back({curve.planes.far, std::string{curve.format.name},
                                  std::string{name_of(curve.interpolation)}, at.depth, at.predicted,
                                  at.measured});
    return table;
}

/// The table of measured over predicted, over all ratios and distances.
Table tightness_table(const std::vector<GapCurve>& curves) {
    Table table{.name = "gap-tightness",
                .caption = "Measured over predicted gap, over all distances and ratios",
                .columns = {{"format", "", ""},
                            {"least", "", ""},
                            {"median", "", ""},
                            {"greatest", "", "More than 1 would disprove the prediction."},
                            {"distances", "", ""}},
                .rows = {}};
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> shares;
    for (const GapCurve& curve : curves) {
        if (!shares.contains(curve.format.name)) order.push_back(curve.format.name);
        for (const GapAt& at : curve.points)
            if (std::isfinite(at.predicted)) shares[curve.format.name].push_back(at.measured / at.predicted);
    }
    for (const std::string& name : order) {
        std::vector<double>& values = shares[name];
        if (values.empty()) continue;
        std::ranges::sort(values);
        table.rows.push_back(
            {name, values.front(), values[values.size() / 2], values.back(), std::int64_t(values.size())});
    }
    return table;
}

Table spread_table(const DepthStudy& study, const std::string& stem) {
    Table table{.name = stem + "-errors",
                .caption = "Errors of the stored depth against the exact one, " + grouped(study.pixels) +
                           " pixels; shares of the depth",
                .columns = {{"interpolation", "", ""},
                            {"format", "", ""},
                            {"median", "", ""},
                            {"p99", "", ""},
                            {"largest", "", ""},
                            {"largest", "scene units", ""},
                            {"of the bound", "", "Largest error / derived bound: at most 1."}},
                .rows = {},
                .shown = 60};
    for (const ErrorSpread& s : study.spreads)
        table.rows.push_back({std::string{name_of(s.interpolation)}, std::string{s.format.name}, s.median,
                              s.p99, s.largest, s.largest_absolute, s.largest_of_bound});
    return table;
}

/// The share of the pixels whose error is no larger.
Series cumulative(const ErrorSpread& spread, const std::string& name) {
    Series series{.name = name, .points = {}};
    const std::vector<double> ends = histogram_ends();
    std::size_t sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        sum += spread.histogram[i];
        series.points.push_back({ends[i], double(sum) / double(spread.pixels)});
    }
    return series;
}

template <class Keep, class Name>
Chart distribution(const DepthStudy& study, const std::string& title, Keep keep, Name name) {
    Chart chart{.title = title,
                .x = {.title = "error / depth", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "share of the pixels with no more", .names = {}},
                .series = {}};
    for (const ErrorSpread& spread : study.spreads)
        if (keep(spread)) chart.series.push_back(cumulative(spread, name(spread)));
    return chart;
}

std::vector<Item> maps(const DepthStudy& study, const std::string& stem) {
    std::vector<Item> items;
    const auto add = [&](const ErrorSpread& spread, const std::string& group) {
        std::string way = name_of(spread.interpolation);
        if (way == "1/z") way = "reciprocal";
        document::Picture picture = document::picture_of(
            stem + "-map-" + way + "-" + spread.format.name,
            std::string{spread.format.name} + ", " + name_of(spread.interpolation) + ": median " +
                rounded(spread.median) + ", largest " + rounded(spread.largest) + " of the depth",
            error_colours(spread.map, {}));
        picture.group = group;
        items.push_back(std::move(picture));
    };
    for (const ErrorSpread& spread : study.spreads)
        if (std::string{spread.format.name} == "z-float32") add(spread, "interpolations");
    for (const ErrorSpread& spread : study.spreads)
        if (spread.interpolation == Interpolation::reciprocal && is_charted(spread.format) &&
            std::string{spread.format.name} != "z-float32")
            add(spread, "formats");
    return items;
}

Section error_section(const DepthStudy& study, const std::string& stem) {
    Section section{study.scene + " / " + study.view + ": errors against exact depths", {}, {}};
    section.paragraphs = {
        "Planes " + rounded(study.planes.near) + " to " + rounded(study.planes.far) + "; " +
            grouped(study.pixels) + " pixels show depths from " + rounded(study.nearest) + " to " +
            rounded(study.farthest) + ", " + grouped(study.left_out) +
            " more lie before near, beyond far or just beside their triangle. The exact depth is that of the "
            "scene's own plane at the pixel's centre, by interval arithmetic and rationals. Corners lie "
            "where "
            "they are, not on a sub-pixel grid: what is studied is depth alone.",
        "In the maps black-violet is 1e-9 of the depth or less, yellow all of it, equal ratios are equally "
        "far "
        "apart, and grey shows nothing."};
    section.items.push_back(spread_table(study, stem));
    section.items.push_back(
        document::Plot{stem + "-formats", "1/z interpolated, by format",
                       distribution(
                           study, "Error by format",
                           [](const ErrorSpread& s) {
                               return s.interpolation == Interpolation::reciprocal && is_charted(s.format);
                           },
                           [](const ErrorSpread& s) { return std::string{s.format.name}; })});
    section.items.push_back(document::Plot{
        stem + "-interpolations", "By interpolation, of three formats",
        distribution(
            study, "Error by interpolation",
            [](const ErrorSpread& s) {
                const std::string name = s.format.name;
                return name == "z-float32" || name == "reversed-float32" || name == "log-float32";
            },
            [](const ErrorSpread& s) {
                return std::string{s.format.name} + ", " + name_of(s.interpolation);
            })});
    std::ranges::move(maps(study, stem), std::back_inserter(section.items));
    return section;
}

Section ladder_section(const DepthStudy& study, const std::string& stem) {
    Table table{.name = stem + "-planes",
                .caption = "99 of 100 pixels err by no more than this share of their depth, by far / near",
                .columns = {{"format", "", ""}},
                .rows = {}};
    Chart chart{.title = "Error as near moves towards the eye",
                .x = {.title = "far / near", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "p99 of error / depth", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    for (const double ratio : study.ratios) table.columns.push_back({power_of_ten(ratio), "", ""});
    Row left;
    left.emplace_back(std::string{"pixels beyond near"});
    for (const double share : study.pixels_left) left.emplace_back(share);
    for (const LadderRow& row : study.ladder) {
        Row cells;
        cells.emplace_back(std::string{row.format.name});
        Series series{.name = row.format.name, .points = {}};
        for (std::size_t i = 0; i < row.p99.size(); ++i) {
            cells.emplace_back(row.p99[i]);
            series.points.push_back({study.ratios[i], row.p99[i]});
        }
        table.rows.push_back(std::move(cells));
        if (is_charted(row.format)) chart.series.push_back(std::move(series));
    }
    table.rows.push_back(std::move(left));
    return {study.scene + " / " + study.view + ": near and far",
            {"Far stays an eighth behind the farthest pixel, near moves. What lies before near is left out."},
            {std::move(table), document::Plot{stem + "-near", "1/z interpolated", std::move(chart)}}};
}

Section fighting_section(const DepthStudy& study, const std::string& stem) {
    Table table{.name = stem + "-fighting",
                .caption = "Share of the picture in which a second layer shows through, by its distance",
                .columns = {{"format", "", ""}},
                .rows = {}};
    Chart chart{
        .title = "Layers that fight",
        .x = {.title = "distance of the layers, scene units", .scale = Scale::logarithmic, .names = {}},
        .y = {.title = "share of the picture", .names = {}},
        .series = {}};
    for (const double delta : study.deltas) table.columns.push_back({rounded(delta), "", ""});
    for (const FightingCurve& curve : study.fighting) {
        Row cells;
        cells.emplace_back(std::string{curve.format.name});
        Series series{.name = curve.format.name, .points = {}};
        for (std::size_t i = 0; i < curve.share.size(); ++i) {
            cells.emplace_back(curve.share[i]);
            series.points.push_back({study.deltas[i], curve.share[i]});
        }
        table.rows.push_back(std::move(cells));
        if (is_charted(curve.format)) chart.series.push_back(std::move(series));
    }
    return {
        study.scene + " / " + study.view + ": layers that fight",
        {"Every triangle lies on a second one whose corners are delta deeper along their view rays. A "
         "pixel fights where the second layer's stored depth is not farther: equal is enough, for then the "
         "order of drawing decides. The view's own planes; 1/z interpolated."},
        {std::move(table), document::Plot{stem + "-fights", "Equal counts as fighting", std::move(chart)}}};
}

}  // namespace

document::Document depth_document(const GapStudy& gaps, const DepthQuestion& question) {
    document::Document document;
    document.title = "Depth: what a z-buffer keeps";
    document.introduction = {
        "Which depth can a buffer hold, which gap between two surfaces does it keep in order, and which "
        "format "
        "does a scene need? Every figure is held against exact depths; every gap is predicted from the "
        "format's step and the float32 roundings of the arithmetic, and tried."};
    document.sections.push_back(
        {"Which format",
         {"A row of the first table is how far apart near and far lie, a column the gap that one needs; it "
          "holds for any near. The second says for one pair of planes what each format keeps."},
         {choice_table(gaps.choices), question_table(question)}});
    Section section{
        "The smallest gap that is kept in order",
        {"Lines are predicted, grey points measured: triangles at random places, drawn again "
         "farther away, until a pixel shows the wrong one. Where a line ends, nothing behind that "
         "distance can be told from far."},
        {}};
    for (const double ratio : {1e1, 1e3, 1e5, 1e7})
        section.items.push_back(document::Plot{"gaps-" + power_of_ten(ratio), "1/z interpolated, near is 1",
                                               gap_chart(gaps.curves, ratio)});
    section.items.push_back(tightness_table(gaps.curves));
    section.items.push_back(document::Plot{"gaps-by-interpolation",
                                           "Where corners are coded first, they bring their own rounding",
                                           ways_chart(gaps.ways)});
    section.items.push_back(gap_table(gaps.curves, "gaps"));
    section.items.push_back(gap_table(gaps.ways, "gaps-of-interpolations"));
    document.sections.push_back(std::move(section));
    return document;
}

std::vector<Section> depth_sections(const DepthStudy& study, const std::string& stem) {
    if (study.pixels == 0)
        return {{study.scene + " / " + study.view,
                 {"No pixel of this view shows anything between its planes."},
                 {}}};
    return {error_section(study, stem), ladder_section(study, stem), fighting_section(study, stem)};
}

}  // namespace zproof
