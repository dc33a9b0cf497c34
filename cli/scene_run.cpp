#include "cli/scene_run.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>

#include "cli/attribute_remarks.h"
#include "cli/memory.h"
#include "cli/oracle_answers.h"
#include "cli/shaded_pictures.h"
#include "cli/stage_clock.h"
#include "cli/view_result.h"
#include "cli/viewer_evidence.h"
#include "compare/attributes/attribute_check.h"
#include "compare/diagnosis/diagnosis.h"
#include "compare/judge.h"
#include "oracle/oracle_error.h"
#include "program/interrupt.h"
#include "program/samples.h"
#include "program/usage_error.h"
#include "renderers/cached_reference.h"
#include "reports/evidence.h"
#include "reports/expectations.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "scenes/scene_hash.h"

namespace zproof {
namespace {

Resolution resolution_of(const SceneSource& source, const RunConfig& config) {
    return source.size.value_or(config.settings.resolution);
}

/// Does the suite's manifest, which is written for the usual pictures, speak of these?
bool has_expectations(const SceneSource& source, const RunConfig& config) {
    return config.settings.resolution == default_resolution &&
           (!source.size || source.size == source.usual_size);
}

/// Candidate, reference and oracles of one scene.
struct OpenedRenderers {
    Renderer candidate, reference;
    std::vector<OpenedOracle> oracles;
};

/// A scene's renderers, and sha256_of(Scene).
struct OpenedScene {
    OpenedRenderers opened;
    std::string scene_sha256;
};

/// Hashing keeps one thread busy, and building trees keeps any number: they go side by side.
OpenedScene open_scene(const RunConfig& config, const Scene& scene, const std::vector<View>& views) {
    const ChosenRenderers& renderers = config.renderers;
    OpenedScene opened_scene;
    tbb::task_group beside;
    beside.run([&] { opened_scene.scene_sha256 = sha256_of(scene); });
    if (!config.reference_cache) opened_scene.opened.reference = open(renderers.reference, scene);
    opened_scene.opened.candidate = open(renderers.candidate, scene);
    opened_scene.opened.oracles = open_oracles(renderers.oracles, scene, views);
    beside.wait();
    if (config.reference_cache)
        opened_scene.opened.reference =
            open_with_cache(renderers.reference, scene, opened_scene.scene_sha256, *config.reference_cache);
    return opened_scene;
}

/// One view with everybody who answers about it.
struct ViewRun {
    const ViewContext& context;
    OpenedRenderers& opened;
    const RunConfig& config;
    StageClock& clock;
    std::size_t place;  ///< among the scene's views
    bool is_last;
};

/// The renderer's frame. After the last view it lets go of what it made of the scene: Embree's tree takes
/// more than the scene itself.
Frame ask(Renderer& renderer, const ViewRun& view_run) {
    Frame frame = renderer.render(view_run.context.view);
    if (view_run.is_last) renderer.render = nullptr;
    return frame;
}

/// What candidate and reference answered, and what the judge said.
struct JudgedPair {
    RenderedFrame candidate, reference;
    Verdict& verdict;  ///< its maps of errors go to the viewer's files
};

/// Asks the oracles, and counts where everybody names the same triangle. Are their frames and pictures kept?
std::vector<OracleAnswer> ask_oracles(const ViewRun& view_run, const JudgedPair& judged, bool is_kept,
                                      ViewResult& result) {
    const Frame &candidate = judged.candidate.frame, &reference = judged.reference.frame;
    std::vector<OracleAnswer> answers;
    for (const OpenedOracle& oracle : view_run.opened.oracles) {
        view_run.config.progress.begin_stage("ask " + name_of(oracle.choice.renderer) + " " +
                                             shown_name(view_run.context.view));
        answers.push_back(ask_oracle(oracle, view_run.context, view_run.place, judged.reference));
    }
    const std::filesystem::path folder = view_run.config.run_folder / result.folder;
    if (is_kept && view_run.config.report.pictures == PictureMode::shaded)
        paint({view_run.context, candidate, judged.verdict.classes, folder}, view_run.opened.oracles,
              answers);
    for (const OracleAnswer& answer : answers) {
        result.oracles.push_back(answer.result);
        if (answer.frame && is_kept) write_oracle_frame(folder, answer.result.name, *answer.frame);
    }
    result.id_agreement = id_agreement_of(candidate, reference, answers);
    const std::string missing = missing_oracle(view_run.opened.oracles, result.oracles);
    if (!missing.empty()) result.outcome = Outcome::unreadable, result.message = missing;
    return answers;
}

/// Tells that a stage begins, and measures it.
void begin(const ViewRun& view_run, const char* what, double StageTimes::*stage) {
    view_run.clock.begin(stage);
    view_run.config.progress.begin_stage(std::string{what} + " " + shown_name(view_run.context.view));
}

bool leaves_evidence(const Verdict& verdict, Evidence mode) {
    return mode == Evidence::all || defect_count(verdict) > 0;
}

/// Those that fail the gate.
std::vector<Finding> failing(std::span<const Finding> findings) {
    std::vector<Finding> found;
    std::ranges::copy_if(findings, std::back_inserter(found),
                         [](const Finding& f) { return !passes(f.verdict); });
    return found;
}

/// What the judge says; of a view that leaves no evidence what the page shows of it. After one that failed
/// the next is likely to fail, and is judged in full at once.
Verdict judge_as_wanted(const ViewRun& view_run, const RenderedFrame& candidate,
                        const RenderedFrame& reference) {
    const ViewContext& context = view_run.context;
    const bool is_likely_right = !view_run.config.early_end.has_seen_a_failure();
    if (view_run.config.report.evidence == Evidence::defects && is_likely_right) {
        JudgeOptions options;
        if (view_run.config.shows_every_view) options.findings = JudgeOptions::Findings::differences;
        Verdict verdict = judge(context.scene, context.view, candidate, reference, options);
        if (!leaves_evidence(verdict, view_run.config.report.evidence)) return verdict;
    }
    return judge(context.scene, context.view, candidate, reference, full_detail);
}

/// Stands for a view of which nothing was judged.
ViewResult unjudged(const SceneSource& source, const View& view, Outcome outcome, const std::string& why) {
    ViewResult result = unjudged(source, outcome, why);
    result.view = shown_name(view);
    return result;
}

/// What is judged of the candidate's attributes, and what is not.
std::vector<std::string> remarks_on_attributes(const ViewRun& view_run, const Attributes& given) {
    const Renderer& candidate = view_run.opened.candidate;
    std::vector<std::string> remarks =
        attribute_remarks(view_run.context.scene, view_run.context.view, given, candidate.precision);
    if (candidate.labels && given.are_given())
        remarks = {"attributes not judged: the frame names no triangles"};
    if (candidate.channels)
        for (const std::string& misnamed : misnamed_attributes(candidate.channels(view_run.context.view)))
            remarks.push_back(misnamed);
    return remarks;
}

/// The candidate's attributes that are judged.
std::vector<std::string> names_of_judged(const ViewRun& view_run, const Attributes& given) {
    const Renderer& candidate = view_run.opened.candidate;
    std::vector<std::string> names;
    if (candidate.labels) return names;
    for (const Attribute attribute :
         judged_attributes(view_run.context.scene, view_run.context.view, given, candidate.precision))
        names.emplace_back(name_of(attribute));
    return names;
}

/// What the page shows of the view; all evidence of one that is kept whole.
void write_pictures(const ViewRun& view_run, const JudgedPair& judged, bool is_whole, ViewResult& result) {
    const ViewContext& context = view_run.context;
    const RunConfig& config = view_run.config;
    begin(view_run, "write", &StageTimes::write);
    result.folder = "scenes/" + config.names.next(context.source.name, shown_name(context.view));
    const std::filesystem::path folder = config.run_folder / result.folder;
    const auto picture = [&](PictureSize size) {
        return picture_of(context, judged.candidate.frame, judged.verdict.classes, size);
    };
    write_view_summary(folder, picture(card_picture), judged.verdict);
    if (!is_whole) return;
    write_view_evidence(folder, judged.candidate.frame, judged.reference.frame, judged.verdict);
    write_large_picture(folder, picture(large_picture));
}

/// The result, its files written while its cause is looked for. Nothing where that was interrupted.
std::optional<ViewResult> explained(const ViewRun& view_run, const CandidateFrame& candidate,
                                    const JudgedPair& judged) {
    const ViewContext& context = view_run.context;
    const RunConfig& config = view_run.config;
    std::optional<Diagnosis> diagnosis;
    bool is_diagnosed = true;
    const auto find_cause = [&, earlier = config.causes.earlier()] {
        diagnosis = diagnose(context.scene, context.view, judged.candidate, judged.reference, judged.verdict,
                             {candidate.said(), view_run.opened.candidate.convention}, {}, earlier);
    };
    tbb::task_group beside;
    if (config.report.diagnosis == CauseSearch::done)
        beside.run([&] { is_diagnosed = done_uninterrupted(find_cause); });
    const bool is_whole = leaves_evidence(judged.verdict, config.report.evidence);
    const std::vector<Finding> told = is_whole ? judged.verdict.findings : failing(judged.verdict.findings);
    ViewResult result = to_view_result(context, judged.verdict, told, config.gate, candidate);
    if (is_whole || config.shows_every_view) write_pictures(view_run, judged, is_whole, result);
    view_run.clock.begin(&StageTimes::oracles);
    const std::vector<OracleAnswer> answers = ask_oracles(view_run, judged, is_whole, result);
    if (!result.folder.empty()) {
        begin(view_run, "write", &StageTimes::write);
        const auto write_for_viewer = is_whole ? write_viewer_evidence : write_viewer_summary;
        write_for_viewer(config.run_folder / result.folder,
                         {context, judged.candidate, judged.reference, judged.verdict, answers});
    }
    begin(view_run, "judge", &StageTimes::judge);
    beside.wait();
    if (!is_diagnosed) {
        if (!result.folder.empty()) std::filesystem::remove_all(config.run_folder / result.folder);
        return std::nullopt;
    }
    result.diagnosis = std::move(diagnosis);
    return result;
}

/// Returns nothing where it was interrupted between two stages.
std::optional<ViewResult> run_view(const ViewRun& view_run) {
    const auto& [context, opened, config, clock, place, is_last] = view_run;
    const auto& [source, scene, scene_sha256, view, renderers] = context;
    if (const std::string refused = refused_projection(opened.candidate.projections, view.camera);
        !refused.empty())
        return unjudged(source, view, Outcome::not_judged,
                        "the renderer's precision lists projections without " + refused);
    if (const std::string outside = outside_judged_ranges(view); !outside.empty())
        return unjudged(source, view, Outcome::unreadable, outside);
    for (const Renderer* renderer : {&opened.candidate, &opened.reference})
        if (const std::string why = unjudgeable(view.camera, renderer->precision); !why.empty())
            return unjudged(source, view, Outcome::unreadable, renderer->name + ": " + why);
    if (const std::string lacking = lacking_memory({view.width, view.height}); !lacking.empty())
        return unjudged(source, view, Outcome::unreadable, lacking);

    begin(view_run, "trace", &StageTimes::reference);
    const Frame reference = ask(opened.reference, view_run);
    if (interrupted()) return std::nullopt;

    begin(view_run, "render", &StageTimes::render);
    Frame given = ask(opened.candidate, view_run);
    if (interrupted()) return std::nullopt;

    begin(view_run, "judge", &StageTimes::judge);
    const std::vector<std::string> remarks = remarks_on_attributes(view_run, given.attributes),
                                   attributes = names_of_judged(view_run, given.attributes);
    const CandidateFrame candidate = candidate_frame(scene, view, opened.candidate, std::move(given),
                                                     {reference, opened.reference.precision});
    const RenderedFrame ours{candidate.frame, opened.candidate.precision},
        theirs{reference, opened.reference.precision};
    Verdict verdict;
    if (!done_uninterrupted([&] { verdict = judge_as_wanted(view_run, ours, theirs); })) return std::nullopt;

    std::optional<ViewResult> result = explained(view_run, candidate, {ours, theirs, verdict});
    if (!result) return std::nullopt;
    result->notes.insert(result->notes.end(), remarks.begin(), remarks.end());
    result->attributes = attributes;
    return result;
}

/// Runs the view. If candidate or reference gives no answer about it, that is a result, and the run goes on.
std::optional<ViewResult> run_view_or_say_why_not(const ViewRun& view_run) {
    const Scene& scene = view_run.context.scene;
    const View& view = view_run.context.view;
    const auto unanswered = [&](const std::string& why) {
        ViewResult result = unjudged(view_run.context.source, view, Outcome::unreadable, why);
        result.candidate = view_run.opened.candidate.name;
        result.reference = view_run.opened.reference.name;
        return result;
    };
    try {
        return run_view(view_run);
    } catch (const OracleError& e) {
        return unanswered(e.what());
    } catch (const std::bad_alloc&) {
        return unanswered(out_of_memory({view.width, view.height}, scene.triangles.size()));
    }
}

std::vector<View> wanted_views(const Loaded& loaded, const ViewChoice& wanted) {
    if (wanted.name.empty() && wanted.many == ViewChoice::Many::are_refused && loaded.views.size() > 1)
        throw UsageError{"compare: " + loaded.scene.name + " has the views " + names_of(loaded.views) +
                         "; say which with --view"};
    return views_named(loaded, wanted.name);
}

ViewResult without_triangles(const SceneSource& source, const Scene& scene) {
    ViewResult result = unjudged(source, Outcome::not_judged, "the scene has no triangles");
    result.notes = scene.notes;
    return result;
}

std::string left_words(const EarlyEnd& early_end) {
    return early_end.is_due() ? early_end.why() : "interrupted before it was judged";
}

/// The scene's results in the making: each is told as soon as it is there.
class Record {
  public:
    Record(const RunConfig& config, std::vector<ViewResult>& results) : config_(config), results_(results) {}

    void add(ViewResult result) {
        config_.progress.tell(result);
        config_.early_end.note(result);
        config_.causes.note(result);
        results_.push_back(std::move(result));
    }

    /// Views that nobody judges: they are counted at the end, and not told one by one.
    void leave(ViewResult result) { results_.push_back(std::move(result)); }

  private:
    const RunConfig& config_;
    std::vector<ViewResult>& results_;
};

/// What came of the view at this place among all of them.
ViewResult at_place(ViewResult result, std::size_t place, const std::vector<View>& views) {
    result.view_place = place;
    result.scene_views = views.size();
    return result;
}

/// What one scene is judged with, and where that is told.
struct SceneRun {
    const SceneSource& source;
    const RunConfig& config;
    StageClock& clock;
    Record& record;

    Ending leave(std::span<const std::size_t> places, const std::vector<View>& views) const {
        const std::string words = left_words(config.early_end);
        for (const std::size_t i : places)
            record.leave(at_place(unjudged(source, views[i], Outcome::not_judged, words), i, views));
        return config.early_end.is_due() ? Ending::stopped : Ending::interrupted;
    }
};

/// Judges the views at these places. A place is counted among all of the scene's views, whoever judges the
/// others.
Ending run_places(const SceneRun& run, const Scene& scene, const std::vector<View>& views,
                  std::span<const std::size_t> places) {
    const auto& [source, config, clock, record] = run;
    config.progress.begin_stage("build");
    clock.begin(&StageTimes::reference_build);
    auto [opened, scene_sha256] = open_scene(config, scene, views);
    while (!places.empty()) {
        const std::size_t i = places.front();
        const ViewContext context{source, scene, scene_sha256, views[i], config.renderers};
        std::optional<ViewResult> result;
        if (!interrupted() && !config.early_end.is_due())
            result = run_view_or_say_why_not({.context = context,
                                              .opened = opened,
                                              .config = config,
                                              .clock = clock,
                                              .place = i,
                                              .is_last = places.size() == 1});
        if (!result) return run.leave(places, views);
        result->times = clock.take();
        config.progress.end_view();
        record.add(at_place(std::move(*result), i, views));
        places = places.subspan(1);
    }
    return Ending::complete;
}

/// A result per view of the share, or one that says that there is nothing to see.
Ending run_views(const SceneRun& run) {
    const auto& [source, config, clock, record] = run;
    config.progress.begin_stage("load");
    const Loaded loaded = load(source, resolution_of(source, config));
    if (loaded.scene.triangles.empty()) {
        places_in(source.share, {});  // a plan may know of views
        if (source.share.has_the_first()) record.add(without_triangles(source, loaded.scene));
        return Ending::complete;
    }
    const std::vector<View> views = at_samples(wanted_views(loaded, config.views), config.settings.samples);
    const std::vector<std::size_t> places = places_in(source.share, views);
    if (places.empty()) return Ending::complete;
    config.progress.expect_views(places.size());
    if (interrupted()) return run.leave(places, views);
    return run_places(run, loaded.scene, views, places);
}

/// Tells again of a view that was told proven, and is not for want of what the suite expects.
void hold_to_expectations(const SceneSource& source, const RunConfig& config,
                          std::vector<ViewResult>& views) {
    if (views.empty()) return;
    for (ViewResult& view : views) view.expects = source.expects;
    const Outcome told = views.back().outcome;
    hold_to_expectations(views);
    if (views.back().outcome == told) return;
    config.progress.tell(views.back());
    config.early_end.note(views.back());
}

/// All views of a scene. One that cannot be read, or in which a renderer cannot begin, is a result.
Ending run_views_or_say_why_not(const SceneSource& source, const RunConfig& config,
                                std::vector<ViewResult>& results) {
    Record record{config, results};
    StageClock clock;
    const auto end_with = [&](ViewResult result) {
        result.times = clock.take();
        config.progress.finish_scene();
        record.add(std::move(result));
        return Ending::complete;
    };
    const auto refuse = [&](const std::string& why) {
        return end_with(unjudged(source, Outcome::unreadable, why));
    };
    const auto give_up = [&](const std::exception& e) {
        return end_with(ended_by_fault(source, config, e.what(), ""));
    };
    try {
        const Ending ending = run_views({source, config, clock, record});
        if (ending == Ending::complete && has_expectations(source, config) &&
            std::ranges::all_of(config.settings.samples, is_centre) && are_the_usual(config.renderers))
            hold_to_expectations(source, config, results);
        return ending;
    } catch (const SceneError& e) {
        return refuse(e.what());
    } catch (const OracleError& e) {
        return refuse(e.what());
    } catch (const std::bad_alloc&) {
        return refuse(out_of_memory_for(source.origin));
    } catch (const std::logic_error& e) {
        return give_up(e);
    }
}

}  // namespace

std::string refused_projection(const Projections& has, const Camera& camera) {
    if (camera.projection == Projection::perspective) return has.perspective ? "" : "perspective";
    if (camera.shear == glm::dvec2(0)) return has.orthographic ? "" : "orthographic";
    return has.oblique ? "" : "oblique";
}

ViewResult ended_by_fault(const SceneSource& source, const RunConfig& config, const std::string& how,
                          const std::string& stage) {
    return unjudged(source, Outcome::internal_error,
                    how + (stage.empty() ? "" : " at '" + stage + "'") + "; to see it again: " +
                        judging_command_for(source, config.renderers, resolution_of(source, config),
                                            config.report.typed));
}

ViewResult left_out(const SceneSource& source, const EarlyEnd& early_end) {
    return unjudged(source, Outcome::not_judged, left_words(early_end));
}

SceneReport run_scene(const SceneSource& source, const RunConfig& config) {
    config.progress.begin_scene(source.name);
    SceneReport report;
    report.ending = run_views_or_say_why_not(source, config, report.views);
    config.progress.finish_scene();
    return report;
}

}  // namespace zproof
