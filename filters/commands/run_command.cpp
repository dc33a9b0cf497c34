#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "filters/commands/commands.h"
#include "filters/commands/evidence_files.h"
#include "filters/commands/study_method.h"
#include "filters/commands/view_evidence.h"
#include "filters/report/folder.h"
#include "filters/report/provenance.h"
#include "filters/report/tables.h"
#include "filters/study/claims.h"
#include "filters/study/study.h"
#include "frame/printable.h"
#include "image_io/image_io.h"
#include "math/sha256.h"
#include "program/common_arguments.h"
#include "program/folder_names.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/scene_selection.h"
#include "program/stopwatch.h"
#include "program/study_scenes.h"
#include "program/usage_error.h"
#include "program/version.h"
#include "program/work_progress.h"
#include "reports/output_folder.h"
#include "scenes/glb_writer.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

study::Plan plan_of(const FiltersRunArguments& arguments) {
    const bool has_floats = std::ranges::any_of(
        arguments.scenes, [](const std::string& word) { return is_photograph_of_floats(word); });
    study::Plan plan{.methods = {},
                     .truth = arguments.truth,
                     .light = has_floats ? LightRange::beyond_white : LightRange::up_to_white,
                     .flicker_steps = arguments.flicker_steps};
    for (const FilterChoice& choice : arguments.methods) plan.methods.push_back(study_method(choice));
    for (const PictureChoice& picture : arguments.pictures) plan.methods.push_back(study_method(picture));
    return plan;
}

/// The study in the making, and the folder that its pictures go to.
class FilterStudyRun {
  public:
    FilterStudyRun(study::Plan plan, const FiltersRunArguments& arguments, const fs::path& folder,
                   WorkProgress& progress, study::StudyResults& results)
        : plan_(std::move(plan)),
          arguments_(arguments),
          folder_(folder),
          progress_(progress),
          results_(results) {}

    /// Methods on views, as far as the views are known.
    Share share() const { return {scored_, views_ * plan_.methods.size(), scenes_left_}; }

    void leave(const StudyScene&) { ++scenes_left_; }  ///< interrupted: not even loaded

    void study_scene(const StudyScene& source) {
        const Loaded loaded = load(source, {arguments_.width, arguments_.height}, arguments_.common);
        const std::vector<View> views = chosen_views(loaded, arguments_.views);
        require_a_file_for_each(arguments_.pictures, 1, views.size());
        for (const View& view : views)
            if (arguments_.inspected) refuse_unfit_box(*arguments_.inspected, plan_.methods.size(), view);
        const std::string name = unique_name(loaded.scene.name, source),
                          sha256 = sha256_of(glb_bytes(loaded.scene));
        progress_.expect_more(double(views.size() - 1) * study::work_of(plan_));
        views_ += views.size();
        for (const View& view : views) {
            if (interrupted()) return;
            plan_.first_row = arguments_.first_row.value_or(natural_first_row(source, view.height));
            progress_.within(name + " / " + view.name + ": ");
            study::ViewStudy one = study_one({source.word, name, sha256}, loaded.scene, view);
            one.scene = name;
            one.scene_sha256 = sha256;
            one.reason = source.reason;
            scored_ += one.methods.size() + one.missing.size();
            results_.views.push_back(std::move(one));
            progress_.estimate_from_here();
        }
    }

  private:
    /// The scene's name, or what was typed where another scene of the study has that name.
    std::string unique_name(const std::string& scene, const StudyScene& source) {
        return scenes_.insert(scene).second ? scene : source.word;
    }

    struct SceneFacts {
        std::string word, name;
        std::string sha256;  ///< of the .glb that zproof would write of it
    };

    study::ViewStudy study_one(const SceneFacts& facts, const Scene& scene, const View& view) {
        const std::string home = "pictures/" + names_.next(facts.name, view.name) + "/";
        study::ViewStudy place{};
        place.scene = facts.name, place.view = view.name, place.scene_sha256 = facts.sha256;
        const FileFacts provenance = provenance_of(results_, place);
        fs::create_directories(folder_ / home);
        ViewEvidenceWriter evidence;
        std::optional<EvidenceFiles> files;
        if (arguments_.writes_evidence) files.emplace(folder_ / home, provenance);
        std::map<std::string, study::ClaimCount> claims;
        const auto tell_claim = [&](const PictureClaim& claim, const std::string& what,
                                    const Picture& picture) {
            const PermittedInterval permitted = permitted_by(claim.claim, picture, scene, view);
            const ClaimedPicture claimed{what, claim.method.typed, claim.promise, picture, permitted};
            claims[what] = {claim.method.typed, claim.promise, pixels_outside(picture, permitted)};
            evidence.claim(claimed);
            if (files) files->claim(claimed);
        };
        const study::ProgressSink progress_sink{
            .begins = [&](const std::string& what, double work) { progress_.begin(what, work); },
            .is_shown =
                [&](const std::string& what, const Picture& picture) {
                    write_picture(folder_ / home / (file_stem(what) + ".exr"), picture, provenance);
                    evidence.show(what, picture);
                    if (files && what != "truth") files->show(what, picture);
                    if (const PictureClaim* claim = find_claim(arguments_.pictures, what))
                        tell_claim(*claim, what, picture);
                },
            .wants_to_stop = interrupted,
            .is_known =
                [&](const study::ViewEvidence& known) {
                    evidence.begin(known);
                    if (files) files->begin(known);
                },
            .is_mapped =
                [&](const std::string& label, const PictureMetric& metric, const Plane<double>& map) {
                    evidence.map(label, metric, map);
                    if (files) files->map(label, metric, map);
                }};
        study::ViewStudy one = study::study_view(scene, view, plan_, progress_sink);
        std::move(evidence).write(folder_ / home, {facts.word, facts.name, scene, view, plan_,
                                                   arguments_.pictures, arguments_.inspected});
        one.truth_file = home + "truth.exr";
        for (study::MethodScore& method : one.methods) {
            method.file = home + file_stem(method.label) + ".exr";
            if (const auto claim = claims.find(method.label); claim != claims.end())
                method.claim = claim->second;
        }
        return one;
    }

    study::Plan plan_;
    const FiltersRunArguments& arguments_;
    fs::path folder_;
    WorkProgress& progress_;
    study::StudyResults& results_;
    FolderNames names_;
    std::set<std::string> scenes_;
    std::size_t scored_ = 0, views_ = 0, scenes_left_ = 0;
};

study::StudyResults results_of(const FiltersRunArguments& arguments, const study::Plan& plan) {
    study::StudyResults results = study::begun(plan);
    results.version = version_number();
    results.commit = commit();
    results.processor = processor_name();
    results.date = utc_now();
    results.command = arguments.typed;
    results.compiler = compiler_name();
    results.threads = arguments.common.threads;
    return results;
}

bool shows_a_texture(const study::ViewStudy& view) {
    return std::ranges::any_of(view.methods, [](const study::MethodScore& m) { return m.cost.pixels > 0; });
}

/// Was there any?
bool say_missing(const study::StudyResults& results) {
    bool is_missing = false;
    for (const study::ViewStudy& view : results.views)
        for (const study::MissingPicture& one : view.missing) {
            const std::string where = view.scene + " / " + view.view + ": " + one.label;
            std::cerr << "zproof: " << one_line(where + ": " + one.reason) << "\n";
            is_missing = true;
        }
    return is_missing;
}

ExitCode conclusion(const study::StudyResults& results, Share share) {
    if (!results.is_complete) return say_interrupted(share, "picture", "scored and written");
    if (say_missing(results)) return ExitCode::cannot_judge;
    if (std::ranges::any_of(results.views, shows_a_texture)) return ExitCode::proven;
    std::cerr << "zproof: nothing to study: no pixel of these scenes shows a texture\n";
    return ExitCode::nothing;
}

}  // namespace

ExitCode execute(const FiltersRunArguments& arguments) {
    const std::vector<StudyScene> scenes = study_scenes(arguments.scenes);
    require_a_file_for_each(arguments.pictures, scenes.size(), 1);
    const study::Plan plan = plan_of(arguments);
    study::StudyResults results = results_of(arguments, plan);
    OutputFolder out{arguments.common.out};
    note_interrupts();
    Stopwatch watch;
    Share share{};
    {
        WorkProgress progress{std::cerr, progress_of(arguments.common),
                              double(scenes.size()) * study::work_of(plan), Estimate::from_half_of_the_work};
        FilterStudyRun study_run{plan, arguments, out.working(), progress, results};
        on_threads(arguments.common.threads, [&] {
            for (const StudyScene& scene : scenes)
                interrupted() ? study_run.leave(scene) : study_run.study_scene(scene);
        });
        share = study_run.share();
    }
    results.is_complete = share.done == share.all && share.scenes_left == 0;
    results.seconds = watch.lap();
    write_filters_results(out.working(), results);
    write_filters_figures({.study = out.working(), .figures = out.working()}, results, {});
    const std::filesystem::path place =
        publish(out, arguments.common, results.is_complete ? Completeness::full : Completeness::partial);
    if (!arguments.common.is_quiet())
        std::cout << filters_table(results, {"interior"}) << claim_lines(results) << "\n";
    std::cout << "study: " << one_line((place / "filters.html").string()) << "\n";
    return conclusion(results, share);
}

}  // namespace zproof
