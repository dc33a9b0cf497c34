#include "cli/scene_run.h"

#include <optional>

#include "cli/expectations.h"
#include "cli/interrupt.h"
#include "cli/stopwatch.h"
#include "cli/view_result.h"
#include "compare/diagnosis.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "rasterizer/rasterizer.h"
#include "reports/evidence.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

/// nullopt: interrupted between two stages.
std::optional<ViewResult> run_view(const Docket& docket, const oracle::Embree& embree, const Desk& desk) {
    const auto& [source, scene, view] = docket;
    StageTimes times;
    Stopwatch watch;

    desk.progress.begin_stage("render " + view.name);
    const Frame candidate = rasterizer::render(scene, view);
    times.render = watch.lap();
    if (interrupted()) return std::nullopt;

    desk.progress.begin_stage("trace " + view.name);
    const Frame reference = embree.trace(view);
    times.reference = watch.lap();
    if (interrupted()) return std::nullopt;

    desk.progress.begin_stage("judge " + view.name);
    const Testimony ours{candidate, rasterizer::precision()}, theirs{reference, oracle::embree_precision()};
    const Verdict verdict = judge(scene, view, ours, theirs);
    ViewResult result = to_view_result(docket, verdict);
    result.diagnosis = diagnose(scene, view, ours, theirs, verdict);
    times.judge = watch.lap();

    desk.progress.begin_stage("write " + view.name);
    result.folder = "scenes/" + desk.names.next(source.name, view.name);
    write_view_evidence(desk.run_folder / result.folder, candidate, reference, verdict);
    times.write = watch.lap();
    result.times = times;
    return result;
}

ViewResult without_triangles(const SceneSource& source, const Scene& scene) {
    ViewResult result = unjudged(source, Outcome::not_judged, "the scene has no triangles");
    result.notes = scene.notes;
    return result;
}

/// Appends a result per judged view.
Ending run_views(const SceneSource& source, const Desk& desk, std::vector<ViewResult>& results) {
    Stopwatch watch;
    desk.progress.begin_stage("load");
    const Loaded loaded = load(source, desk.resolution);
    const double load_time = watch.lap();
    if (loaded.scene.triangles.empty()) {
        results.push_back(without_triangles(source, loaded.scene));
        return Ending::complete;
    }
    if (interrupted()) return Ending::interrupted;

    desk.progress.begin_stage("build");
    const oracle::Embree embree{loaded.scene};
    const double build_time = watch.lap();

    for (const View& view : loaded.views) {
        if (interrupted()) return Ending::interrupted;
        std::optional<ViewResult> result = run_view({source, loaded.scene, view}, embree, desk);
        if (!result) return Ending::interrupted;
        if (results.empty()) {
            result->times.load = load_time;
            result->times.reference_build = build_time;
        }
        results.push_back(std::move(*result));
    }
    return Ending::complete;
}

}  // namespace

ViewResult left_by_interrupt(const SceneSource& source) {
    return unjudged(source, Outcome::not_judged, "interrupted before it was judged");
}

SceneReport run_scene(const SceneSource& source, const Desk& desk) {
    desk.progress.begin_scene(source.name);
    SceneReport report;
    try {
        report.ending = run_views(source, desk, report.views);
        if (report.ending == Ending::interrupted)
            report.views.push_back(left_by_interrupt(source));
        else if (desk.resolution == default_resolution)
            hold_to_expectations(source, report.views);
    } catch (const SceneError& e) {
        report.views.push_back(unjudged(source, Outcome::unreadable, e.what()));
    } catch (const OracleError& e) {
        report.views.push_back(unjudged(source, Outcome::unreadable, e.what()));
    }
    for (const ViewResult& view : report.views) desk.progress.finish_view(view);
    return report;
}

}  // namespace zproof
