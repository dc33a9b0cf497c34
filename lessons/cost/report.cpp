#include "lessons/cost/report.h"

#include <algorithm>
#include <cmath>

#include "reports/wording.h"

namespace zproof {
namespace {

using namespace study::cost;
using document::Row;
using document::Section;
using document::Table;

constexpr double microseconds = 1e-3, milliseconds = 1e-6;  // of a nanosecond

std::string percent(double share) { return rounded(100 * share) + " %"; }

Table constant_table(const Fit& fit, const std::string& name, const std::string& caption) {
    Table table{.name = name,
                .caption = caption,
                .columns = {{"constant", "", ""},
                            {"value", "ns", ""},
                            {"standard error", "ns", "From the residuals; nan where it is not determined."},
                            {"determined", "",
                             "1: the runs fix it. Less: another constant can take its place, and only their "
                             "sum is known."},
                            {"is the time of", "", ""}},
                .rows = {}};
    const std::vector<std::string> names = constant_names();
    for (std::size_t i = 0; i < names.size(); ++i)
        table.rows.push_back({names[i], fit.constant[i], fit.standard_error[i],
                              std::round(1e6 * fit.determined[i]) / 1e6, constant_meaning(names[i])});
    return table;
}

Table run_table(const std::vector<Run>& runs, const Fit& fit, const std::string& name) {
    Table table{.name = name,
                .caption = "Every run: medians with quartiles, and what the model makes of it",
                .columns = {{"varied", "", ""},
                            {"stages", "", ""},
                            {"v", "", "vertices"},
                            {"triangles", "", "set up"},
                            {"d m^2", "", "fragments"},
                            {"m^2", "", "pixels"},
                            {"measured", "us", ""},
                            {"quartiles", "us", ""},
                            {"predicted", "us", ""},
                            {"residual", "", "predicted / measured - 1"}},
                .rows = {},
                .shown = 80};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        const auto whole = [](double number) { return std::int64_t(number); };
        table.rows.push_back(
            {run.varied, words_for(run.stages), whole(run.quantities.vertices),
             whole(run.quantities.triangles), whole(run.quantities.fragments), whole(run.quantities.pixels),
             run.timing.median * microseconds,
             rounded(run.timing.low * microseconds) + " to " + rounded(run.timing.high * microseconds),
             (1 + fit.residual[i]) * run.timing.median * microseconds, fit.residual[i]});
    }
    return table;
}

Chart residual_chart(const std::vector<Run>& runs, const Fit& fit) {
    Chart chart{.title = "Residuals, run by run",
                .x = {.title = "measured, us", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "predicted / measured - 1", .names = {}},
                .series = {}};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (chart.series.empty() || chart.series.back().name != runs[i].varied)
            chart.series.push_back({.name = runs[i].varied, .points = {}, .joining = Joining::points});
        chart.series.back().points.push_back({runs[i].timing.median * microseconds, fit.residual[i]});
    }
    return chart;
}

/// The chart of predicted over measured of whole pipelines, and the line on which both are equal.
Chart prediction_chart(const std::vector<Prediction>& predictions) {
    Chart chart{.title = "Scenes that took no part in the fit",
                .x = {.title = "measured, ms", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "predicted, ms", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    Series equal{.name = "equal", .points = {}, .style = SeriesStyle::muted};
    for (const Prediction& p : predictions) {
        const double measured = p.timing.median * milliseconds;
        chart.series.push_back({.name = p.scene + " / " + p.view,
                                .points = {{measured, p.predicted * milliseconds}},
                                .joining = Joining::points});
        equal.points.push_back({measured, measured});
    }
    std::ranges::sort(equal.points);
    chart.series.push_back(std::move(equal));
    return chart;
}

std::string quality_of(const Fit& fit) {
    return "residuals " + percent(fit.rms_residual) + " RMS and at most " + percent(fit.largest_residual) +
           "; rank " + std::to_string(fit.rank) + " of " + std::to_string(fit.constant.size()) +
           "; condition number " + rounded(fit.condition);
}

Section apart_section(const Model& model) {
    return {"The constants",
            {"Generated scenes vary the number of vertices, of triangles, of layers and of pixels, one at a "
             "time. "
             "Stages are left out in turn, for the three constants that multiply v cannot be told apart "
             "otherwise. Rows are weighted so that residuals are shares of the time: " +
             quality_of(model.fit) + "."},
            {constant_table(model.fit, "constants", "Fitted to stages that were left out in turn"),
             document::Plot{"residuals", "A model that fits leaves no pattern",
                            residual_chart(model.runs, model.fit)},
             run_table(model.runs, model.fit, "runs")}};
}

Section whole_section(const Model& model) {
    const Fit& fit = model.whole_fit;
    const double sum = fit.constant[0] + fit.constant[1] + fit.constant[2];
    const double apart = model.fit.constant[0] + model.fit.constant[1] + model.fit.constant[2];
    return {
        "What whole frames alone can tell",
        {"Measured from outside, as one would measure any program: whole frames of meshes at four finenesses "
         "and three resolutions, no stage left out. k_bus, k_xform and k_shade have one and the same "
         "factor: only their sum is known, " +
         rounded(sum) + " ns a vertex here, " + rounded(apart) +
         " ns from the stages above. That they come out equal is the shortest solution's doing and "
         "means nothing. A mesh's triangles and vertices grow together, and so do the pixels that it "
         "covers and the image: " +
         quality_of(fit) + "."},
        {constant_table(fit, "constants-of-whole-frames", "Fitted to whole frames only"),
         run_table(model.whole_runs, fit, "whole-runs")}};
}

Table work_table(const OptimizationStudy& study, const std::string& stem) {
    Table table{.name = stem + "-optimizations",
                .caption =
                    "Visibility: what each optimization saves. Times are medians; ids and depths against the "
                    "plain z-buffer's, defects by the gate",
                .columns = {{"optimization", "", ""},
                            {"time", "ms", ""},
                            {"quartiles", "ms", ""},
                            {"of plain", "", ""},
                            {"vertices", "", "transformed"},
                            {"triangles", "", "set up"},
                            {"fragments", "", "tested"},
                            {"written", "", "tests passed"},
                            {"blocks", "", "4 x 4 pixels a triangle may cover"},
                            {"hidden blocks", "", "left alone"},
                            {"other ids", "px", ""},
                            {"other depths", "px", ""},
                            {"defects", "px", "that fail the gate"}},
                .rows = {}};
    const double plain = study.runs.front().timing.median;
    for (const OptimizationRun& run : study.runs) {
        const auto& tally = run.work.tally;
        const auto whole = [](std::uint64_t number) { return std::int64_t(number); };
        table.rows.push_back(
            {run.name, run.timing.median * milliseconds,
             rounded(run.timing.low * milliseconds) + " to " + rounded(run.timing.high * milliseconds),
             run.timing.median / plain, whole(run.work.vertices), whole(run.work.bins.set_up),
             whole(tally.fragments), whole(tally.written), whole(tally.blocks), whole(tally.hidden_blocks),
             whole(run.same.other_ids), whole(run.same.other_depths), whole(run.same.defects)});
    }
    return table;
}

Table shading_table(const OptimizationStudy& study, const std::string& stem) {
    Table table{.name = stem + "-early-z",
                .caption = "Shading: when a fragment is shaded. Colours against the deferred picture's",
                .columns = {{"order", "", ""},
                            {"shaded", "", "fragments"},
                            {"time", "ms", "visibility and shading"},
                            {"quartiles", "ms", ""},
                            {"other colours", "px", ""}},
                .rows = {}};
    for (const ShadingRun& run : study.shading)
        table.rows.push_back(
            {run.name, std::int64_t(run.shaded), run.timing.median * milliseconds,
             rounded(run.timing.low * milliseconds) + " to " + rounded(run.timing.high * milliseconds),
             std::int64_t(run.other_colours)});
    return table;
}

std::string closedness(const OptimizationStudy& study) {
    if (study.open_edges == 0)
        return "The scene is closed: every edge has its other side, so back faces may be left out where the "
               "eye is outside and near cuts nothing open.";
    return "The scene is open (" + grouped(study.open_edges) +
           " edges without another side): leaving out back faces is no optimization here but another "
           "picture, and "
           "the gate's defects are its price.";
}

}  // namespace

document::Document cost_document(const Model& model) {
    document::Document document;
    document.title = "Cost: what a z-buffer's time is made of";
    document.introduction = {
        "The lecture's model, k_bus v + k_xform v + k_shade v + k_setup triangles + k_fragment d m^2, with "
        "two "
        "terms that it leaves out (a pixel that is cleared and written, a run that draws nothing), fitted to "
        "this machine and held against scenes that took no part. Times are processor time of one thread, "
        "medians with quartiles; counts are exact and the same for any number of threads."};
    document.sections = {apart_section(model), whole_section(model)};
    return document;
}

std::vector<Section> prediction_sections(const std::vector<Prediction>& predictions) {
    if (predictions.empty()) return {};
    Table table{.name = "predictions",
                .caption = "The model against scenes that took no part in the fit, no optimization used",
                .columns = {{"view", "", ""},
                            {"v", "", "vertices"},
                            {"triangles", "", "set up"},
                            {"d", "", "depth complexity"},
                            {"fragments / block", "", "of 16: what a triangle covers of the blocks it meets"},
                            {"m^2", "", "pixels"},
                            {"measured", "ms", ""},
                            {"predicted", "ms", ""},
                            {"predicted / measured", "", ""}},
                .rows = {}};
    for (const std::string& name : constant_names()) table.columns.push_back({name, "share", ""});
    for (const Prediction& p : predictions) {
        const Quantities& q = p.quantities;
        Row row{p.scene + " / " + p.view,       std::int64_t(q.vertices),   std::int64_t(q.triangles),
                q.fragments / q.pixels,         q.fragments / q.blocks,     std::int64_t(q.pixels),
                p.timing.median * milliseconds, p.predicted * milliseconds, p.predicted / p.timing.median};
        for (const double share : p.share) row.push_back(share);
        table.rows.push_back(std::move(row));
    }
    return {
        {"Prediction against measurement",
         {"A share is a term's part of the prediction. The model knows neither a triangle's size nor whether "
          "a fragment is written or only tested, so scenes of triangles much larger or smaller than those "
          "of the fit are off by what that costs."},
         {std::move(table),
          document::Plot{"prediction", "On the grey line both are equal", prediction_chart(predictions)}}}};
}

Section optimization_section(const OptimizationStudy& study, const std::string& stem) {
    return {study.scene + " / " + study.view + ": the optimizations",
            {closedness(study),
             "Early z and its kin matter where shading costs: the second table shades each fragment as the "
             "pictures of `zproof run --pictures` are shaded."},
            {work_table(study, stem), shading_table(study, stem)}};
}

}  // namespace zproof
