#include <iostream>
#include <sstream>

#include "filters/commands/checked_picture.h"
#include "filters/commands/claim.h"
#include "filters/commands/commands.h"
#include "filters/commands/joint_check.h"
#include "filters/conformance/picture_format.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/selftest/filter_fault.h"
#include "filters/selftest/likely_cause.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/study_scenes.h"
#include "program/usage_error.h"
#include "program/work_progress.h"

namespace zproof {
namespace {

using selftest::ConformanceResult;
using selftest::FilterClaim;
using selftest::FilterFixture;

Picture picture_of(const FilterFixture& fixture, const FilterChoice& choice, const FilterPrecision& promise,
                   const std::filesystem::path& own) {
    if (!own.empty()) return picture_in(own, fixture.view);
    return as_stored(rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, choice.texturing),
                     promise);
}

/// Judges every method on one view; how many of them keep to their definition.
class FilterChecker {
  public:
    FilterChecker(const FiltersCheckArguments& arguments, std::size_t scenes)
        : arguments_(arguments),
          scenes_left_(scenes),
          progress_(std::cerr, progress_beside_lines(arguments.common),
                    double(scenes * arguments.methods.size())) {}

    /// The next scene: it may have more views than the one that progress expects of each.
    void begin_scene(std::size_t views) {
        --scenes_left_;
        expected_ += views * arguments_.methods.size();
        progress_.expect_more(double((views - 1) * arguments_.methods.size()));
    }

    void judge(const FilterFixture& fixture) {
        for (const FilterChoice& choice : arguments_.methods) {
            if (interrupted()) return;
            progress_.begin(fixture.scene.name + " / " + fixture.view.name + ": " + choice.typed + ": ");
            const CheckedPicture checked = judged(fixture, choice);
            if (arguments_.format == CheckFormat::json)
                json_.push_back(to_json(checked));
            else if (!arguments_.common.is_quiet())
                progress_.say(std::cout, in_words(checked));
            ++judged_;
            failed_ += checked.is_wrong(), open_ += checked.is_open();
        }
    }

    ExitCode outcome() {
        std::ostringstream line;
        line << judged_ << (judged_ == 1 ? " picture: " : " pictures: ") << judged_ - failed_ - open_
             << " within the reference of their method, " << failed_ << " not";
        if (open_ > 0) line << ", " << open_ << " of which nothing is proved";
        line << "\n";
        const nlohmann::json pictures{{"pictures", json_}};
        progress_.say(std::cout,
                      arguments_.format == CheckFormat::json ? pictures.dump(2) + "\n" : line.str());
        if (std::size_t(judged_) < expected_ || scenes_left_ > 0)
            return say_interrupted({std::size_t(judged_), expected_, scenes_left_}, "picture", "judged");
        if (judged_ == 0) return ExitCode::nothing;
        if (failed_ > 0) return ExitCode::defect;
        return open_ == 0 ? ExitCode::proven : ExitCode::cannot_judge;
    }

  private:
    /// Beside zproof's own promise, which is exact, no joint error could hide, and every defect that shows is
    /// seen.
    CheckedPicture judged(const FilterFixture& fixture, const FilterChoice& choice) const {
        const FilterClaim claim = claim_of(choice, arguments_.precision);
        const Picture picture = picture_of(fixture, choice, claim.precision, arguments_.picture);
        CheckedPicture checked{.scene = fixture.scene.name,
                               .view = fixture.view.name,
                               .method = choice.typed,
                               .result = selftest::conformance_of(picture, fixture, claim)};
        if (arguments_.precision || !arguments_.picture.empty()) {
            const JointCheck check = joint_check_of(fixture, claim);
            checked.joint = check.judge(picture);
            if (!checked.is_wrong()) checked.power = power_of(fixture, claim, checked.result.found, check);
        }
        checked.causes = causes_of(picture, fixture, claim, checked.result);
        return checked;
    }

    static std::vector<std::string> causes_of(const Picture& picture, const FilterFixture& fixture,
                                              const FilterClaim& claim, const ConformanceResult& result) {
        if (result.found.outside == 0) return {};
        return selftest::causes_of(picture, selftest::ChangedDefinitions{fixture, claim}, claim, result.found,
                                   selftest::likely_changes(fixture.scene, claim));
    }

    const FiltersCheckArguments& arguments_;
    nlohmann::json json_ = nlohmann::json::array();
    int judged_ = 0, failed_ = 0, open_ = 0;  ///< open: nothing is proved
    std::size_t expected_ = 0;                ///< pictures of the scenes that were begun
    std::size_t scenes_left_;
    WorkProgress progress_;
};

}  // namespace

ExitCode execute(const FiltersCheckArguments& arguments) {
    for (const FilterChoice& choice : arguments.methods) claim_of(choice, arguments.precision);
    const std::vector<StudyScene> sources = study_scenes(arguments.scenes);
    note_interrupts();
    FilterChecker checker{arguments, sources.size()};
    std::size_t views_judged = 0;
    for (const StudyScene& source : sources) {
        if (interrupted()) break;
        const Loaded loaded = load(source, {arguments.width, arguments.height}, arguments.common);
        const std::vector<View> views = chosen_views(loaded, arguments.views);
        checker.begin_scene(views.size());
        views_judged += views.size();
        if (!arguments.picture.empty() && views_judged > 1)
            throw UsageError{"--picture: one view is expected; name it (--view)"};
        for (const View& view : views)
            on_threads(arguments.common.threads, [&] {
                checker.judge({loaded.scene, view, oracle::exact_visibility(loaded.scene, view)});
            });
    }
    return checker.outcome();
}

}  // namespace zproof
