#include "cli/scene_run.h"

#include <optional>

#include "cli/expectations.h"
#include "cli/interrupt.h"
#include "cli/shaded_pictures.h"
#include "cli/stopwatch.h"
#include "cli/usage_error.h"
#include "cli/view_result.h"
#include "cli/viewer_evidence.h"
#include "cli/witness_hearing.h"
#include "compare/diagnosis.h"
#include "oracle/oracle_error.h"
#include "reports/evidence.h"
#include "scenes/scene_error.h"
#include "scenes/scene_hash.h"

namespace zproof {
namespace {

/// Candidate, reference and witnesses of one scene.
struct Court {
    Renderer candidate, reference;
    std::vector<SummonedWitness> witnesses;
};

/// One view with everybody who answers about it.
struct Trial {
    const Docket& docket;
    Court& court;
    const Desk& desk;
    bool is_last;  ///< of the scene
};

/// The renderer's frame. After the last view it lets go of what it made of the scene: Embree's tree takes
/// more than the scene itself.
Frame ask(Renderer& renderer, const Trial& trial) {
    Frame frame = renderer.render(trial.docket.view);
    if (trial.is_last) renderer.render = nullptr;
    return frame;
}

/// What candidate and reference answered, and what the judge said.
struct JudgedPair {
    Testimony candidate, reference;
    const Verdict& verdict;
};

/// Asks the witnesses, and counts where everybody names the same triangle.
std::vector<Statement> hear_witnesses(const Trial& trial, const JudgedPair& judged, ViewResult& result) {
    const Frame &candidate = judged.candidate.frame, &reference = judged.reference.frame;
    std::vector<Statement> statements;
    for (const SummonedWitness& witness : trial.court.witnesses) {
        trial.desk.progress.begin_stage("ask " + name_of(witness.choice.renderer) + " " +
                                        trial.docket.view.name);
        statements.push_back(hear(witness, trial.docket, judged.reference));
    }
    const std::filesystem::path folder = trial.desk.run_folder / result.folder;
    if (trial.desk.pictures == PictureWish::shaded)
        paint({trial.docket, candidate, judged.verdict.classes, folder}, trial.court.witnesses, statements);
    std::vector<const Frame*> frames{&candidate, &reference};
    for (const Statement& statement : statements) {
        result.witnesses.push_back(statement.result);
        if (!statement.frame) continue;
        frames.push_back(statement.frame.get());
        write_witness_frame(folder, statement.result.name, *statement.frame);
    }
    result.accord = accord_of(frames);
    const std::string missing = missing_witness(trial.court.witnesses, result.witnesses);
    if (!missing.empty()) result.outcome = Outcome::unreadable, result.message = missing;
    return statements;
}

/// nullopt: interrupted between two stages.
std::optional<ViewResult> run_view(const Trial& trial) {
    const auto& [docket, court, desk, is_last] = trial;
    const auto& [source, scene, scene_sha256, view, parties] = docket;
    StageTimes times;
    Stopwatch watch;

    desk.progress.begin_stage("trace " + view.name);
    const Frame reference = ask(court.reference, trial);
    times.reference = watch.lap();
    if (interrupted()) return std::nullopt;

    desk.progress.begin_stage("render " + view.name);
    const Frame candidate = ask(court.candidate, trial);
    times.render = watch.lap();
    if (interrupted()) return std::nullopt;

    desk.progress.begin_stage("judge " + view.name);
    const Testimony ours{candidate, court.candidate.precision}, theirs{reference, court.reference.precision};
    auto [verdict, errors, rulings] = judge_in_full(scene, view, ours, theirs);
    ViewResult result = to_view_result(docket, verdict, desk.gate);
    result.diagnosis = diagnose(scene, view, ours, theirs, verdict);
    times.judge = watch.lap();

    desk.progress.begin_stage("write " + view.name);
    result.folder = "scenes/" + desk.names.next(source.name, view.name);
    write_view_evidence(desk.run_folder / result.folder, candidate, reference, verdict);
    times.write = watch.lap();

    const std::vector<Statement> statements = hear_witnesses(trial, {ours, theirs, verdict}, result);
    times.witnesses = watch.lap();

    desk.progress.begin_stage("write " + view.name);
    write_viewer_evidence(desk.run_folder / result.folder,
                          {docket, ours, theirs, verdict, std::move(errors), rulings, statements});
    times.write += watch.lap();
    result.times = times;
    return result;
}

/// The same; a view about which candidate or reference gave no answer is a result, and the run goes on.
std::optional<ViewResult> run_view_or_say_why_not(const Trial& trial) {
    try {
        return run_view(trial);
    } catch (const OracleError& e) {
        ViewResult result = unjudged(trial.docket.source, Outcome::unreadable, e.what());
        result.view = trial.docket.view.name;
        result.candidate = trial.court.candidate.name;
        result.reference = trial.court.reference.name;
        return result;
    }
}

/// All of them, or the one that was asked for.
std::vector<View> wanted_views(const Loaded& loaded, const std::string& only_view) {
    if (only_view.empty()) return loaded.views;
    std::vector<View> views = loaded.views;
    std::erase_if(views, [&](const View& view) { return view.name != only_view; });
    if (!views.empty()) return views;
    throw UsageError{"--view " + only_view + ": " + loaded.scene.name + " has the views " +
                     names_of(loaded.views)};
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
    const std::string scene_sha256 = sha256_of(loaded.scene);
    const double load_time = watch.lap();
    if (loaded.scene.triangles.empty()) {
        results.push_back(without_triangles(source, loaded.scene));
        return Ending::complete;
    }
    if (interrupted()) return Ending::interrupted;

    desk.progress.begin_stage("build");
    Court court{open(desk.parties.candidate, loaded.scene), open(desk.parties.reference, loaded.scene),
                summon(desk.parties.witnesses, loaded.scene)};
    const double build_time = watch.lap();

    const std::vector<View> views = wanted_views(loaded, desk.only_view);
    desk.progress.expect_views(views.size());
    for (const View& view : views) {
        if (interrupted()) return Ending::interrupted;
        const Docket docket{source, loaded.scene, scene_sha256, view, desk.parties};
        std::optional<ViewResult> result = run_view_or_say_why_not(
            {.docket = docket, .court = court, .desk = desk, .is_last = &view == &views.back()});
        if (!result) return Ending::interrupted;
        if (results.empty()) {
            result->times.load = load_time;
            result->times.reference_build = build_time;
        }
        results.push_back(std::move(*result));
        desk.progress.end_view();
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
        else if (desk.resolution == default_resolution && are_the_usual(desk.parties))
            hold_to_expectations(source, report.views);
    } catch (const SceneError& e) {
        report.views.push_back(unjudged(source, Outcome::unreadable, e.what()));
    } catch (const OracleError& e) {
        report.views.push_back(unjudged(source, Outcome::unreadable, e.what()));
    }
    desk.progress.finish_scene();
    for (const ViewResult& view : report.views) desk.progress.tell(view);
    return report;
}

}  // namespace zproof
