#include "cli/shrinker.h"

#include <algorithm>
#include <optional>

#include "cli/labelled_candidate.h"
#include "cli/view_result.h"
#include "compare/judge.h"
#include "frame/number_text.h"
#include "oracle/oracle_error.h"
#include "program/interrupt.h"
#include "program/samples.h"
#include "renderers/registry.h"
#include "reports/wording.h"
#include "scenes/glb_writer.h"
#include "scenes/shrink.h"

namespace zproof {
namespace {

constexpr std::size_t most_shrunk = 3;

/// How a view fails: the class of most of its defects; nothing: the candidate gives no frame.
using Failure = std::optional<PixelClass>;

std::optional<Failure> failure_of(const ViewResult& result) {
    if (result.outcome == Outcome::unreadable && !result.view.empty()) return Failure{};
    if (result.outcome != Outcome::defective || defect_count(result) == 0) return std::nullopt;
    std::size_t most = 0;
    for (std::size_t i = 0; i < result.counts.size(); ++i)
        if (!passes(PixelClass(i)) && (passes(PixelClass(most)) || result.counts[i] > result.counts[most]))
            most = i;
    return PixelClass(most);
}

/// Failures of one name are taken for one.
std::string name_of_failure(const Failure& failure, const ViewResult& result) {
    const bool has_cause = result.diagnosis && result.diagnosis->cause;
    return (failure ? std::string(name_of(*failure)) : "unreadable") +
           (has_cause ? ", " + result.diagnosis->cause->name : "");
}

/// A scene rendered by candidate and reference, and judged.
class Trial {
  public:
    Trial(const ChosenRenderers& renderers, const SceneAndView& at) {
        const Renderer reference = open(renderers.reference, at.scene);
        const Frame theirs = reference.render(at.view);
        try {
            judge_candidate(open(renderers.candidate, at.scene), reference, theirs, at);
        } catch (const OracleError&) {
            fails_to_answer_ = true;
        }
    }

    bool fails(const Failure& failure) const {
        if (!failure) return fails_to_answer_;
        return std::ranges::any_of(findings_, [&](const Finding& f) { return f.verdict == *failure; });
    }
    /// The first pixel that fails so.
    glm::ivec2 pixel(PixelClass failing) const {
        const auto first = std::ranges::find(findings_, failing, &Finding::verdict);
        return first == findings_.end() ? glm::ivec2(0) : glm::ivec2(first->x, first->y);
    }

  private:
    void judge_candidate(const Renderer& candidate, const Renderer& reference, const Frame& theirs,
                         const SceneAndView& at) {
        if (!refused_projection(candidate.projections, at.view.camera).empty()) return;
        const CandidateFrame ours = candidate_frame(at.scene, at.view, candidate, candidate.render(at.view),
                                                    {theirs, reference.precision});
        findings_ = judge(at.scene, at.view, {ours.frame, candidate.precision}, {theirs, reference.precision})
                        .findings;
    }

    std::vector<Finding> findings_;
    bool fails_to_answer_ = false;
};

/// A smaller scene at which a renderer breaks down otherwise does not count.
bool still_fails(const ChosenRenderers& renderers, const SceneAndView& at, const Failure& failure) {
    try {
        return Trial(renderers, at).fails(failure);
    } catch (const std::exception&) {
        return false;
    }
}

std::optional<View> view_of(const Loaded& loaded, const RunConfig& config, const ViewResult& result) {
    const std::vector<View> views = at_samples(loaded.views, config.settings.samples);
    const auto view = std::ranges::find(views, result.view, shown_name);
    return view == views.end() ? std::nullopt : std::optional(*view);
}

SceneSize size_of(const SceneAndView& at) {
    return {at.scene.triangles.size(), at.view.width, at.view.height};
}

/// The command that shows the failure in the file that was written.
std::string command_for(const RunConfig& config, const std::filesystem::path& file, const SceneAndView& least,
                        const Failure& failure) {
    const SceneSource source{
        SceneSource::Kind::view_file, least.scene.name, file.generic_string(), "", {}, 0};
    if (!failure)
        return judging_command_for(source, config.renderers, config.settings.resolution, config.report.typed);
    const glm::ivec2 pixel = Trial(config.renderers, least).pixel(*failure);
    return explain_command_for({source, least.scene, "", least.view, config.renderers},
                               config.renderers.candidate, pixel.x, pixel.y);
}

std::string scene_size_in_words(const SceneSize& size) {
    return counted(size.triangles, "triangle") + " at " + size_text(size.width, size.height);
}

}  // namespace

void Shrinker::look_at(const SceneSource& source, ViewResult& result) {
    const std::optional<Failure> failure = failure_of(result);
    const bool is_stored = std::holds_alternative<StoredFrame>(config_.renderers.candidate.who);
    if (!failure || source.kind != SceneSource::Kind::random || is_stored || seen_.size() >= most_shrunk ||
        !seen_.insert(name_of_failure(*failure, result)).second)
        return;
    config_.progress.begin_stage("shrink");
    Loaded loaded = load(source, config_.settings.resolution);
    const std::optional<View> view = view_of(loaded, config_, result);
    if (!view) return;
    const SceneAndView failing{std::move(loaded.scene), *view};
    auto [least, tries] =
        shrink(failing, [&](const SceneAndView& at) { return still_fails(config_.renderers, at, *failure); },
               {.is_stopped = interrupted});
    std::ranges::replace(least.scene.name = source.name, ':', '-');
    const std::filesystem::path file = "shrunk/" + least.scene.name + ".view.json";
    std::filesystem::create_directories(config_.run_folder / "shrunk");
    write_glb(config_.run_folder / "shrunk", {least.scene, {least.view}});
    result.shrunk = {.file = file.generic_string(),
                     .before = size_of(failing),
                     .after = size_of(least),
                     .tries = tries,
                     .command = command_for(config_, config_.report.common.out / file, least, *failure)};
}

std::string shrunk_in_words(const Results& results, const std::filesystem::path& planned,
                            const std::filesystem::path& folder) {
    std::string text;
    for (const ViewResult& view : results.views) {
        if (!view.shrunk) continue;
        const auto& [file, before, after, tries, typed] = *view.shrunk;
        std::string command = typed;
        const std::string written = (planned / file).generic_string();
        if (const std::size_t at = command.find(written); at != command.npos)
            command.replace(at, written.size(), (folder / file).generic_string());
        text += one_line(view.scene) + ": " + scene_size_in_words(before) + ", shrunk to " +
                scene_size_in_words(after) + " in " + grouped(std::uint64_t(tries)) + " tries\n    " +
                one_line(command) + "\n";
    }
    return text;
}

}  // namespace zproof
