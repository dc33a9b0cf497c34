#include "cli/scene_run.h"

#include <tbb/task_group.h>

#include <optional>
#include <span>

#include "cli/expectations.h"
#include "cli/interrupt.h"
#include "cli/shaded_pictures.h"
#include "cli/stage_clock.h"
#include "cli/usage_error.h"
#include "cli/view_result.h"
#include "cli/viewer_evidence.h"
#include "cli/witness_hearing.h"
#include "compare/diagnosis/diagnosis.h"
#include "compare/judge.h"
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

/// A scene's court, and sha256_of(Scene).
struct Session {
    Court court;
    std::string scene_sha256;
};

/// Hashing keeps one thread busy, and building trees keeps any number: they go side by side.
Session open_session(const Parties& parties, const Scene& scene) {
    Session session;
    tbb::task_group beside;
    beside.run([&] { session.scene_sha256 = sha256_of(scene); });
    session.court = {open(parties.candidate, scene), open(parties.reference, scene),
                     summon(parties.witnesses, scene)};
    beside.wait();
    return session;
}

/// One view with everybody who answers about it.
struct Trial {
    const Docket& docket;
    Court& court;
    const Desk& desk;
    StageClock& clock;
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
    RenderedFrame candidate, reference;
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
    const bool is_kept = !result.folder.empty();
    if (is_kept && trial.desk.pictures == PictureWish::shaded)
        paint({trial.docket, candidate, judged.verdict.classes, folder}, trial.court.witnesses, statements);
    std::vector<const Frame*> frames{&candidate, &reference};
    for (const Statement& statement : statements) {
        result.witnesses.push_back(statement.result);
        if (!statement.frame) continue;
        frames.push_back(statement.frame.get());
        if (is_kept) write_witness_frame(folder, statement.result.name, *statement.frame);
    }
    result.accord = accord_of(frames);
    const std::string missing = missing_witness(trial.court.witnesses, result.witnesses);
    if (!missing.empty()) result.outcome = Outcome::unreadable, result.message = missing;
    return statements;
}

/// Tells that a stage begins, and measures it.
void begin(const Trial& trial, const char* what, double StageTimes::*stage) {
    trial.clock.begin(stage);
    trial.desk.progress.begin_stage(std::string{what} + " " + trial.docket.view.name);
}

bool leaves_evidence(const Verdict& verdict, Evidence wish) {
    return wish == Evidence::all || defect_count(verdict) > 0;
}

/// What the judge says; of a view that leaves no evidence without any.
Verdict judge_as_wanted(const Trial& trial, const RenderedFrame& candidate, const RenderedFrame& reference) {
    const Docket& docket = trial.docket;
    if (trial.desk.evidence == Evidence::defects) {
        Verdict verdict = judge(docket.scene, docket.view, candidate, reference);
        if (!leaves_evidence(verdict, trial.desk.evidence)) return verdict;
    }
    return judge(docket.scene, docket.view, candidate, reference, all_evidence);
}

/// nullopt: interrupted between two stages.
std::optional<ViewResult> run_view(const Trial& trial) {
    const auto& [docket, court, desk, clock, is_last] = trial;
    const auto& [source, scene, scene_sha256, view, parties] = docket;

    begin(trial, "trace", &StageTimes::reference);
    const Frame reference = ask(court.reference, trial);
    if (interrupted()) return std::nullopt;

    begin(trial, "render", &StageTimes::render);
    const Frame candidate = ask(court.candidate, trial);
    if (interrupted()) return std::nullopt;

    begin(trial, "judge", &StageTimes::judge);
    const RenderedFrame ours{candidate, court.candidate.precision},
        theirs{reference, court.reference.precision};
    Verdict verdict = judge_as_wanted(trial, ours, theirs);
    ViewResult result = to_view_result(docket, verdict, desk.gate);
    result.diagnosis = diagnose(scene, view, ours, theirs, verdict);

    if (leaves_evidence(verdict, desk.evidence)) {
        begin(trial, "write", &StageTimes::write);
        result.folder = "scenes/" + desk.names.next(source.name, view.name);
        write_view_evidence(desk.run_folder / result.folder, candidate, reference, verdict);
    }

    clock.begin(&StageTimes::witnesses);
    const std::vector<Statement> statements = hear_witnesses(trial, {ours, theirs, verdict}, result);

    if (result.folder.empty()) return result;
    begin(trial, "write", &StageTimes::write);
    write_viewer_evidence(desk.run_folder / result.folder, {docket, ours, theirs, verdict, statements});
    return result;
}

/// Stands for a view of which nothing was judged.
ViewResult unjudged(const SceneSource& source, const View& view, Outcome outcome, const std::string& why) {
    ViewResult result = unjudged(source, outcome, why);
    result.view = view.name;
    return result;
}

/// The same; a view about which candidate or reference gave no answer is a result, and the run goes on.
std::optional<ViewResult> run_view_or_say_why_not(const Trial& trial) {
    try {
        return run_view(trial);
    } catch (const OracleError& e) {
        ViewResult result = unjudged(trial.docket.source, trial.docket.view, Outcome::unreadable, e.what());
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

constexpr const char* left_words = "interrupted before it was judged";

/// The scene's results in the making: each is told as soon as it is there.
class Record {
  public:
    Record(const Desk& desk, std::vector<ViewResult>& results) : desk_(desk), results_(results) {}

    void add(ViewResult result) {
        desk_.progress.tell(result);
        results_.push_back(std::move(result));
    }

    /// All the views from this one on.
    void leave(const SceneSource& source, std::span<const View> views) {
        for (const View& view : views) add(unjudged(source, view, Outcome::not_judged, left_words));
    }

  private:
    const Desk& desk_;
    std::vector<ViewResult>& results_;
};

/// A result per view, or one that says that there is nothing to see.
Ending run_views(const SceneSource& source, const Desk& desk, StageClock& clock, Record& record) {
    desk.progress.begin_stage("load");
    const Loaded loaded = load(source, desk.resolution);
    if (loaded.scene.triangles.empty()) {
        record.add(without_triangles(source, loaded.scene));
        return Ending::complete;
    }
    const std::vector<View> views = wanted_views(loaded, desk.only_view);
    desk.progress.expect_views(views.size());
    const auto leave = [&](std::size_t from) {
        record.leave(source, std::span{views}.subspan(from));
        return Ending::interrupted;
    };
    if (interrupted()) return leave(0);

    desk.progress.begin_stage("build");
    clock.begin(&StageTimes::reference_build);
    auto [court, scene_sha256] = open_session(desk.parties, loaded.scene);
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (interrupted()) return leave(i);
        const Docket docket{source, loaded.scene, scene_sha256, views[i], desk.parties};
        std::optional<ViewResult> result = run_view_or_say_why_not({.docket = docket,
                                                                    .court = court,
                                                                    .desk = desk,
                                                                    .clock = clock,
                                                                    .is_last = i + 1 == views.size()});
        if (!result) return leave(i);
        result->times = clock.take();
        desk.progress.end_view();
        record.add(std::move(*result));
    }
    return Ending::complete;
}

/// Tells again of a view that was told proven, and is not for want of what the suite expects.
void hold_to_expectations(const SceneSource& source, const Desk& desk, std::vector<ViewResult>& views) {
    const Outcome told = views.back().outcome;
    hold_to_expectations(source, views);
    if (views.back().outcome != told) desk.progress.tell(views.back());
}

/// All views of a scene. One that cannot be read, or in which a renderer cannot begin, is a result.
Ending run_views_or_say_why_not(const SceneSource& source, const Desk& desk,
                                std::vector<ViewResult>& results) {
    Record record{desk, results};
    StageClock clock;
    const auto refuse = [&](const std::exception& e) {
        ViewResult result = unjudged(source, Outcome::unreadable, e.what());
        result.times = clock.take();
        desk.progress.finish_scene();
        record.add(std::move(result));
        return Ending::complete;
    };
    try {
        const Ending ending = run_views(source, desk, clock, record);
        if (ending == Ending::complete && desk.resolution == default_resolution &&
            are_the_usual(desk.parties))
            hold_to_expectations(source, desk, results);
        return ending;
    } catch (const SceneError& e) {
        return refuse(e);
    } catch (const OracleError& e) {
        return refuse(e);
    }
}

}  // namespace

ViewResult left_by_interrupt(const SceneSource& source) {
    return unjudged(source, Outcome::not_judged, left_words);
}

SceneReport run_scene(const SceneSource& source, const Desk& desk) {
    desk.progress.begin_scene(source.name);
    SceneReport report;
    report.ending = run_views_or_say_why_not(source, desk, report.views);
    desk.progress.finish_scene();
    return report;
}

}  // namespace zproof
