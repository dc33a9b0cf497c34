#include <iomanip>
#include <iostream>
#include <sstream>

#include "filters/commands/check_power.h"
#include "filters/commands/claim.h"
#include "filters/commands/commands.h"
#include "filters/commands/joint_check.h"
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

/// "0 of 262144 pixels outside, slack 0.93"
std::string found_in_words(const ConformanceResult& result) {
    if (result.is_caught()) return selftest::in_words(result);
    std::ostringstream text;
    text << "no pixel of " << result.found.judged << " outside, slack " << std::setprecision(3)
         << result.found.worst_slack;
    if (result.found.anything > 0) text << "; " << result.found.anything << " undecided";
    if (result.chance) text << "; " << selftest::in_words(*result.chance);
    return text.str();
}

std::string where_in_words(const Conformance& found) {
    if (!found.where) return "";
    std::ostringstream text;
    text << "; worst at (" << found.worst.x << ", " << found.worst.y << "), all within columns "
         << found.where->first.x << " to " << found.where->last.x << ", rows " << found.where->first.y
         << " to " << found.where->last.y;
    return text.str();
}

Picture picture_of(const FilterFixture& fixture, const FilterChoice& choice,
                   const std::filesystem::path& own) {
    if (own.empty())
        return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, choice.texturing);
    return picture_in(own, fixture.view);
}

/// The picture against its promise as a whole, and what the check could have seen of one that passes.
struct WholePicture {
    std::optional<JointConformance> joint;
    std::optional<CheckPower> power;

    bool is_open() const { return power && !power->proves_something(); }

    /// Estimates mean nothing where any picture would pass.
    std::vector<std::string> words(const Conformance& found) const {
        std::vector<std::string> lines;
        if (joint) lines = is_open() ? std::vector{promised_in_words(*joint)} : in_words(*joint);
        if (power) std::ranges::copy(in_words(*power, found), std::back_inserter(lines));
        return lines;
    }
};

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
            const std::string name =
                fixture.scene.name + " / " + fixture.view.name + ": " + choice.typed + ": ";
            progress_.begin(name);
            const Picture picture = picture_of(fixture, choice, arguments_.picture);
            const FilterClaim claim = claim_of(choice, arguments_.precision);
            const ConformanceResult result = selftest::conformance_of(picture, fixture, claim);
            const WholePicture whole = whole_picture(picture, fixture, claim, result);
            const bool is_wrong = result.is_caught() || (whole.joint && whole.joint->leaves_promise());
            const bool is_open = !is_wrong && whole.is_open();
            tell((is_wrong  ? "FAILED  "
                  : is_open ? "nothing "
                            : "passed  ") +
                 name + found_in_words(result) +
                 selftest::causes_in_words(causes_of(picture, fixture, claim, result)) +
                 where_in_words(result.found) + "\n");
            for (const std::string& line : whole.words(result.found)) tell("        " + line + "\n");
            ++judged_;
            failed_ += is_wrong, open_ += is_open;
        }
    }

    ExitCode outcome() {
        std::ostringstream line;
        line << judged_ << (judged_ == 1 ? " picture: " : " pictures: ") << judged_ - failed_ - open_
             << " within the reference of their method, " << failed_ << " not";
        if (open_ > 0) line << ", " << open_ << " of which nothing is proved";
        line << "\n";
        progress_.say(std::cout, line.str());
        if (std::size_t(judged_) < expected_ || scenes_left_ > 0)
            return say_interrupted({std::size_t(judged_), expected_, scenes_left_}, "picture", "judged");
        if (judged_ == 0) return ExitCode::nothing;
        if (failed_ > 0) return ExitCode::defect;
        return open_ == 0 ? ExitCode::proven : ExitCode::cannot_judge;
    }

  private:
    /// What is asked of the picture as a whole. Beside zproof's own promise, which is exact, no joint error
    /// could hide, and every defect that shows is seen.
    WholePicture whole_picture(const Picture& picture, const FilterFixture& fixture, const FilterClaim& claim,
                               const ConformanceResult& result) const {
        if (!arguments_.precision && arguments_.picture.empty()) return {};
        const JointCheck check = joint_check_of(fixture, claim);
        WholePicture whole{.joint = check.judge(picture), .power = {}};
        const bool is_right = !result.is_caught() && !whole.joint->leaves_promise();
        if (is_right) whole.power = power_of(fixture, claim, result.found, check);
        return whole;
    }

    static std::vector<std::string> causes_of(const Picture& picture, const FilterFixture& fixture,
                                              const FilterClaim& claim, const ConformanceResult& result) {
        if (result.found.outside == 0) return {};
        return selftest::causes_of(picture, selftest::ChangedDefinitions{fixture, claim}, claim, result.found,
                                   selftest::likely_changes(fixture.scene, claim));
    }

    void tell(const std::string& line) {
        if (!arguments_.common.is_quiet()) progress_.say(std::cout, line);
    }

    const FiltersCheckArguments& arguments_;
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
        const Resolution natural = natural_resolution(source);
        const Loaded loaded = load(
            source, {arguments.width.value_or(natural.width), arguments.height.value_or(natural.height)});
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
